"""Words of the mistakes a drawing may show: what is wrong and how to mend it, in Russian and in English."""

from __future__ import annotations

MISTAKES: dict[str, tuple[str, str]] = {
    # mistakes: {mark} is where it was made
    "mistake_other_assembly": (
        "{mark}: взята другая сборка, второе пересечение засечек; постройте точку по другую сторону",
        "{mark}: the other assembly was taken, the second crossing; put the point on the other side",
    ),
    "mistake_angle_sense": (
        "{mark}: угол ведущего звена отложен не от той оси или не в ту сторону; он считается от оси x против часовой "
        "стрелки",
        "{mark}: the driver's angle is measured from another axis or the other way; count it from x, counter-clockwise",
    ),
    "mistake_link_scale": (
        "{mark}: длина {value} начерчена в другом масштабе (в {ratio} раза); отложите её в масштабе плана",
        "{mark}: the length {value} is drawn in another scale ({ratio} times); lay it off in the plan's scale",
    ),
    "mistake_guide_offset_ignored": (
        "{mark}: не учтено смещение направляющей; проведите её на заданном расстоянии",
        "{mark}: the guide's offset is left out; draw the guide at its given distance",
    ),
    "mistake_omega1_reversed": (
        "{mark}: скорость направлена против вращения ведущего звена; поверните вектор на 180°",
        "{mark}: the velocity points against the driver's rotation; turn the vector by 180°",
    ),
    "mistake_along_link": (
        "{mark}: линия скорости проведена вдоль звена {line}, а относительная скорость ему перпендикулярна",
        "{mark}: the line of the velocity runs along the link {line}; a relative velocity is perpendicular to it",
    ),
    "mistake_wrong_link": (
        "{mark}: перпендикуляр проведён не к тому звену: {other} вместо ⊥{line}",
        "{mark}: the perpendicular is to the wrong link: {other} instead of ⊥{line}",
    ),
    "mistake_relative_from_pole": (
        "{mark}: линия относительной скорости проведена из полюса, а абсолютной — из конца известного вектора; "
        "относительные векторы в обход полюса, абсолютные из полюса",
        "{mark}: the line of the relative velocity starts at the pole and that of the absolute one does not; absolute "
        "vectors start at the pole, relative ones at the end of the known vector",
    ),
    "mistake_relative_reversed": (
        "{mark}: относительная скорость отложена в обратную сторону (v_B − v_CB вместо v_B + v_CB)",
        "{mark}: the relative velocity is laid off backwards (v_B − v_CB instead of v_B + v_CB)",
    ),
    "mistake_similarity_mirrored": (
        "{mark}: подобная фигура зеркальна; обходите её вершины в том же порядке, что на звене",
        "{mark}: the similar figure is mirrored; go round it in the same sense as on the link",
    ),
    "mistake_divided_from_wrong_end": (
        "{mark}: отрезок {start}–{end} разделён не с того конца",
        "{mark}: the segment {start}–{end} is divided from the wrong end",
    ),
    "mistake_similarity_on_pole_segments": (
        "{mark}: подобие построено на отрезке из полюса, а не на {start}–{end}",
        "{mark}: the similar figure stands on a segment from the pole instead of {start}–{end}",
    ),
    "mistake_across_guide": (
        "{mark}: относительный вектор проведён поперёк направляющей {guide}, а должен быть вдоль неё",
        "{mark}: the relative vector is drawn across the guide {guide}; it runs along it",
    ),
    "mistake_normal_outward": (
        "{mark}: нормальное ускорение направлено от центра вращения; оно направлено к центру",
        "{mark}: the normal acceleration points away from the centre of rotation; it points towards it",
    ),
    "mistake_normal_missing": (
        "{mark}: пропущено нормальное ускорение; отложите v²/l к центру вращения",
        "{mark}: the normal acceleration is left out; lay v²/l off towards the centre of rotation",
    ),
    "mistake_normal_wrong_velocity": (
        "{mark}: нормальное ускорение посчитано по другой скорости ({other} вместо {value})",
        "{mark}: the normal acceleration is reckoned from another velocity ({other} instead of {value})",
    ),
    "mistake_normal_from_pole": (
        "{mark}: нормальное ускорение отложено из полюса, а не из конца известного вектора",
        "{mark}: the normal acceleration starts at the pole instead of the end of the known vector",
    ),
    "mistake_tangential_along_link": (
        "{mark}: касательное ускорение проведено вдоль звена {line}, а оно ему перпендикулярно",
        "{mark}: the tangential acceleration runs along the link {line}; it is perpendicular to it",
    ),
    "mistake_epsilon1_ignored": (
        "{mark}: не учтено угловое ускорение ведущего звена; добавьте касательное ускорение ε₁·l",
        "{mark}: the driver's angular acceleration is left out; add the tangential part ε₁·l",
    ),
    "mistake_epsilon1_reversed": (
        "{mark}: касательное ускорение ведущего звена направлено против ε₁; поверните его на 180°",
        "{mark}: the driver's tangential acceleration points against ε₁; turn it by 180°",
    ),
    "mistake_coriolis_missing": (
        "{mark}: пропущено кориолисово ускорение 2ωv; направляющая вращается",
        "{mark}: the Coriolis acceleration 2ωv is left out; the guide turns",
    ),
    "mistake_coriolis_reversed": (
        "{mark}: кориолисово ускорение направлено в обратную сторону; поверните относительную скорость на "
        "90° в сторону ω",
        "{mark}: the Coriolis acceleration is reversed; turn the relative velocity by 90° in the sense of ω",
    ),
    "mistake_coriolis_half": (
        "{mark}: кориолисово ускорение вдвое меньше; в формуле 2ωv потеряна двойка",
        "{mark}: the Coriolis acceleration is half of what it is; the 2 of 2ωv is lost",
    ),
    "mistake_coriolis_wrong_omega": (
        "{mark}: в кориолисовом ускорении взята {other}; нужна угловая скорость направляющей {value}",
        "{mark}: the Coriolis acceleration uses {other}; it takes the guide's angular velocity {value}",
    ),
    "mistake_coriolis_along_guide": (
        "{mark}: кориолисово ускорение отложено вдоль направляющей, а оно ей перпендикулярно",
        "{mark}: the Coriolis acceleration lies along the guide; it is perpendicular to it",
    ),
    "mistake_similarity_on_tangential": (
        "{mark}: подобие построено на касательной части {normal}–{end}, а нужно на полном {start}–{end}",
        "{mark}: the similar figure stands on the tangential part {normal}–{end}; it needs the whole {start}–{end}",
    ),
    "mistake_inertia_along_acceleration": (
        "{mark}: сила инерции направлена по ускорению, а она ему противоположна",
        "{mark}: the force of inertia points along the acceleration; it is opposite to it",
    ),
    "mistake_inertia_moment_reversed": (
        "{mark}: момент сил инерции {force} взят по угловому ускорению, а он ему противоположен",
        "{mark}: the moment of inertia {force} is taken along the angular acceleration; it is opposite to it",
    ),
    "mistake_weight_missing": (
        "{mark}: в плане нет силы тяжести; добавьте её вниз",
        "{mark}: the weight is not in the plan; add it, pointing down",
    ),
    "mistake_mass_for_weight": (
        "{mark}: вместо веса отложена масса; умножьте её на g",
        "{mark}: the mass is laid off for the weight; multiply it by g",
    ),
    "mistake_force_missing": ("{mark}: этой силы нет в плане", "{mark}: this force is not in the plan"),
    "mistake_force_doubled": ("{mark}: эта сила отложена дважды", "{mark}: this force is laid off twice"),
    "mistake_moment_sign": (
        "{mark}: в уравнении моментов знак слагаемого с {force} обратный",
        "{mark}: in the equation of moments the term with {force} has the wrong sign",
    ),
    "mistake_arm_wrong": (
        "{mark}: в уравнении моментов плечо силы {force} взято не как перпендикуляр к линии действия (или не в тех "
        "единицах)",
        "{mark}: in the equation of moments the arm of {force} is not the perpendicular to its line (or is in other "
        "units)",
    ),
    "mistake_tangential_reversed": (
        "{mark}: касательная реакция отложена в обратную сторону; знак минус из уравнения моментов меняет направление",
        "{mark}: the tangential reaction is laid off backwards; a minus from the moments reverses its direction",
    ),
    "mistake_reaction_along_loaded_link": (
        "{mark}: реакция направлена вдоль нагруженного звена; у неё есть и касательная часть из уравнения моментов",
        "{mark}: the reaction runs along a loaded link; it has a tangential part too, from the moments",
    ),
    "mistake_guide_reaction_not_normal": (
        "{mark}: реакция направляющей {guide} не перпендикулярна ей",
        "{mark}: the reaction of the guide {guide} is not perpendicular to it",
    ),
    "mistake_reaction_not_reversed": (
        "{mark}: реакция перенесена без перемены направления; действие и противодействие противоположны",
        "{mark}: the reaction is carried over unreversed; action and reaction are opposite",
    ),
    "mistake_friction_along_motion": (
        "{mark}: трение направлено по движению ползуна, а оно против него",
        "{mark}: the friction points along the slider's motion; it acts against it",
    ),
    "mistake_not_closed": (
        "многоугольник сил не замкнут на {gap} мм; последняя реакция приходит в начало",
        "the force polygon does not close, by {gap} mm; the last reaction ends where the first force starts",
    ),
    "mistake_mu_inverted": (
        "{mark}: число отличается в μ² раз: отрезок умножен на μ вместо деления (или наоборот)",
        "{mark}: the number is off by μ²: the segment was multiplied by μ instead of divided, or the other way round",
    ),
    "mistake_mm_for_value": (
        "{mark}: записаны миллиметры отрезка, а не величина; примените масштаб",
        "{mark}: the millimetres of the segment stand for the value; apply the scale",
    ),
    "mistake_omega_without_mu_l": (
        "{mark}: скорость разделена на миллиметры чертежа; делите на длину звена в метрах",
        "{mark}: the rate is divided by millimetres on paper; divide by the link's length in metres",
    ),
    "mistake_sense_wrong": (
        "{mark}: величина верна, а знак (направление вращения) обратный",
        "{mark}: the size is right, the sign (sense of rotation) is not",
    ),
    "mistake_epsilon_from_total": (
        "{mark}: угловое ускорение посчитано по полному относительному ускорению; нужна его касательная часть",
        "{mark}: the angular acceleration is taken from the whole relative acceleration; it needs the tangential part",
    ),
}
