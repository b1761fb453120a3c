"""Words for a mechanism or vectors stated wrongly in a scene: key to Russian and English."""

LINKS: dict[str, tuple[str, str]] = {
    # the frame and the links
    "frame_empty": ("стойке нужны точки (points) или направляющие (guides)", "the frame needs points or guides"),
    "links_empty": (
        "links: здесь пусто; в механизме должно быть хотя бы одно звено",
        "links is empty; a mechanism needs at least one link",
    ),
    "point_pole": (
        "{what}: точку нельзя назвать p, это полюс каждого плана; напишите P",
        "{what}: a point cannot be named p, the pole of every plan; write P",
    ),
    "points_alike": (
        "{one} и {two} выглядят одинаково, но написаны разными буквами (латиница и кириллица); если это одна точка, "
        "напишите её везде одинаково",
        "{one} and {two} look the same but are written in different letters (Latin and Cyrillic); if they are one "
        "point, write it the same everywhere",
    ),
    "link_zero": (
        "звено нельзя назвать 0, это номер стойки; точки стойки записывают в frame",
        "a link cannot be named 0, the frame's own name; write its points under frame",
    ),
    "no_points": ("{what}: нет точек; назовите хотя бы одну", "{what} has no points; name at least one"),
    "angle_already": (
        "{what}: при задании через {form} угол уже определён; уберите angle или пишите through",
        "{what} is given by {form}, so it has its angle already; remove angle or write through",
    ),
    "guide_twice": (
        "направляющая {guide} звена {name} названа так же, как направляющая {owner:of}; имена направляющих в сцене не "
        "повторяются",
        "the guide {guide} of link {name} has the name of a guide of {owner}; guide names are unique in a scene",
    ),
    "no_guide": (
        'звено {name} скользит по "{guide}", но такой направляющей нет{valid}',
        'link {name} slides on "{guide}", but there is no such guide{valid}',
    ),
    "own_guide": (
        "звено {name} скользит по собственной направляющей {guide}; направляющая должна принадлежать другому звену или "
        "стойке",
        "link {name} slides on its own guide {guide}; the guide must be another link's or the frame's",
    ),
    # assembly, drive, loads, friction
    "assembly_name": (
        'assembly: нет ни точки, ни направляющей "{name}"{valid}',
        'assembly: there is no point or guide "{name}"{valid}',
    ),
    "one_drive": (
        "drive: здесь список, а ведущее звено может быть только одно; пишите drive: {{link: 1, phi: 30}}",
        "drive is a list, but there is only one driver; write drive: {{link: 1, phi: 30}}",
    ),
    "drive_no_slide": (
        "drive задаёт s, но звено {link} не скользит по направляющей стойки; пишите phi или задайте slides звена "
        "{link}",
        "drive gives s, but link {link} slides on no guide of the frame; write phi, or slides of link {link}",
    ),
    "other_rate": (
        "когда ведущее звено задано через {kind}, ключа {wrong} нет; пишите {right}",
        "a drive given by {kind} has no {wrong}; write {right}",
    ),
    "frame_still": (
        "{what}: 0 обозначает стойку, а она неподвижна{valid}",
        "{what} is 0, the frame, which does not move{valid}",
    ),
    "force_no_point": (
        "{what}: у силы должна быть точка приложения, ключ point{valid}",
        "{what} is a force, so it needs the key point{valid}",
    ),
    "force_no_direction": (
        "{what}: нет направления; пишите direction: градусы, along: motion или against: motion",
        "{what} has no direction; write direction: degrees, along: motion or against: motion",
    ),
    "moment_has_no": (
        "{what}: у момента нет ключа {key}; положительный момент направлен против часовой стрелки",
        "{what} is a moment, so it has no {key}; a positive one turns counter-clockwise",
    ),
    "friction_no_slide": (
        'friction: по направляющей "{name}" не скользит ни одно звено{valid}',
        'friction: no link slides on guide "{name}"{valid}',
    ),
    "friction_no_guide": ('friction: нет направляющей "{name}"{valid}', 'friction: there is no guide "{name}"{valid}'),
    "law_frozen": (
        "{what}: число зависит от {parameter}, от которого взято и {kind} ведущего звена, и верно только при "
        "{kind} = {value}; для других положений задайте его числом или своим параметром",
        "{what} depends on {parameter}, from which {kind} of the drive is taken, so it holds at {kind} = {value} "
        "alone; for other positions give it as a number or by a parameter of its own",
    ),
    # vectors and equations
    "vectors_parallel": (
        "{text}: векторы {along} и {across} параллельны, и многоугольник не замкнуть; измените направление одного из "
        "них",
        "{text}: {along} and {across} are parallel, so the polygon cannot close; change the direction of one of them",
    ),
    "vectors_coincident": (
        "{text}: векторы {along} и {across} лежат на одной прямой, и их длины не определены (0/0); задайте одну из них "
        "или измените направление",
        "{text}: {along} and {across} lie on one line, so their lengths are not determined (0/0); give one of them or "
        "change a direction",
    ),
    "vectors_arc_short": (
        "{text}: вектор {radius} короче, чем нужно, чтобы достать до прямой вектора {along}, на {miss_mm}; увеличьте "
        "его или измените направление",
        "{text}: {radius} is too short to reach the line of {along}, by {miss_mm}; make it longer or change a "
        "direction",
    ),
    "vectors_arcs_apart": (
        "{text}: векторы {radius} и {other_radius} вместе короче, чем нужно, на {miss_mm}, и многоугольник не "
        "замкнуть; увеличьте один из них",
        "{text}: {radius} and {other_radius} together are too short by {miss_mm}, so the polygon cannot close; make "
        "one of them longer",
    ),
    "vectors_arcs_inside": (
        "{text}: один из векторов {radius} и {other_radius} длиннее, чем нужно, на {miss_mm}, и многоугольник не "
        "замкнуть; измените их величины",
        "{text}: one of {radius} and {other_radius} is too long by {miss_mm}, so the polygon cannot close; change "
        "their values",
    ),
    "vectors_arcs_coincide": (
        "{text}: векторы {radius} и {other_radius} равны по величине, а остальные в сумме дают ноль, и направление "
        "может быть любым (0/0); задайте одно из направлений",
        "{text}: {radius} and {other_radius} are equally long and the rest add up to zero, so any direction would do "
        "(0/0); give one of the directions",
    ),
    "vectors_no_length": (
        "{text}: величина {radius} равна нулю, и направление у этого вектора не найти; задайте её больше нуля",
        "{text}: the value of {radius} is zero, so it has no direction to find; give it more than zero",
    ),
    "vectors_no_lengths": (
        "{text}: одна из величин {radius}, {other_radius} равна нулю, и направление у этого вектора не найти; задайте "
        "её больше нуля",
        "{text}: one of the values {radius}, {other_radius} is zero, so it has no direction to find; give it more than "
        "zero",
    ),
    "vectors_empty": ("vectors: здесь пусто; назовите хотя бы один вектор", "vectors is empty; name at least one"),
    "bad_vector": (
        "{name} не может быть именем вектора; допустимы буквы, цифры, _ ^ и ' без пробелов, не больше {most} знаков",
        "{name} cannot be the name of a vector; valid are letters, digits, _ ^ and ' without spaces, at most {most} of "
        "them",
    ),
    "equations_empty": (
        "equations: здесь пусто; запишите хотя бы одно уравнение",
        "equations is empty; write at least one",
    ),
    "not_equation": (
        "{text} не уравнение; пишите так: v_C = v_B + v_CB",
        "{text} is not an equation; write it as v_C = v_B + v_CB",
    ),
    "one_equals": ("{text}: в уравнении ровно один знак =", "{text}: an equation has exactly one ="),
    "vector_twice": (
        "{text}: {name} стоит дважды; каждый вектор входит в уравнение один раз",
        "{text}: {name} stands twice; name each vector once",
    ),
    "no_vectors": ("{text}: в уравнении нет векторов", "{text}: there is no vector in it"),
    "not_vector": ("{text}: здесь нужно имя вектора, а не {name}", "{text}: {name} is not the name of a vector"),
    "nothing": ("пустое место", "'nothing'"),
    "side_empty": (
        "{text}: одна часть пуста; если в ней ничего нет, пишите 0",
        "{text}: one side is empty; write 0 if nothing stands there",
    ),
    "chain_order": (
        "{text}: {name} начинается в {start}, а построение дошло до {reached}; пишите векторы в том порядке, в каком "
        "они следуют друг за другом",
        "{text}: {name} starts at {start}, but the drawing has reached {reached}; write the vectors in the order they "
        "follow each other",
    ),
    "chain_ends": (
        "{text}: левая часть ведёт из {start} в {end}, правая из {other_start} в {other_end}; какой-то вектор пропущен "
        "или назван наоборот",
        "{text}: the left side leads from {start} to {end}, the right side from {other_start} to {other_end}; a vector "
        "is missing or named the other way round",
    ),
    "chain_broken": (
        "{text}: {name} начинается в {start}, а построение дошло до {reached}",
        "{text}: {name} starts at {start}, but the drawing has reached {reached}",
    ),
    "sides_apart": (
        "{text}: одна часть ведёт из {start} в {end}, другая из {other_start} в {other_end}; обе должны начинаться и "
        "кончаться в одних точках",
        "{text}: one side leads from {start} to {end}, the other from {other_start} to {other_end}; both sides must "
        "start and end at the same points",
    ),
    "unknown_length": ("величина {name}", "length of {name}"),
    "unknown_direction": ("направление {name}", "direction of {name}"),
    "none": ("нет", "none"),
    "unknowns_count": (
        "{text}: неизвестных {count} ({listed:; }), а из векторного уравнения на плоскости находят ровно два",
        "{text} has {count} unknowns ({listed:; }); a plane vector equation gives exactly two",
    ),
    "unknowns_are": (
        "{text}: неизвестные: {listed}; из векторного уравнения находят ровно две величины",
        "{text}: the unknowns are {listed}; a vector equation gives exactly two",
    ),
    "no_vector": ("{text}: нет вектора {name}{valid}", "{text}: there is no vector {name}{valid}"),
    "two_directions": (
        "вектор {name} может быть направлен двояко; добавьте {offers: или }",
        "vector {name} can point in two directions; add {offers: or }",
    ),
    "vector_idle": (
        "вектора {name} нет ни в одном уравнении; добавьте его в уравнение или уберите",
        "vector {name} stands in no equation; write it into one or remove it",
    ),
    "near_idle": (
        "near вектора {name} ничего не решает: его направление однозначно; уберите near",
        "near of vector {name} decides nothing, as its direction is certain; remove near",
    ),
    "vectors_mixed": (
        "{name} строят на {one:of}, а {other_name} на {other:of}: у плана один масштаб μ; запишите их в отдельные "
        "сцены или переименуйте",
        "{name} belongs on the {one} and {other_name} on the {other}, but one plan has one μ; write them into scenes "
        "of their own, or rename them",
    ),
    "vectors_mu": (
        "mu не подходит вектору {name}: на {plan:of} масштаб задают в {units}",
        "mu does not fit {name}: a {plan} has its scale in {units}",
    ),
    "near_angle": ("near: {angle:.4g}", "near: {angle:.4g}"),
}
