"""Words of the report: balancing. Key to Russian and English."""

from __future__ import annotations

BALANCE: dict[str, tuple[str, str]] = {
    "h_balancing": ("4 Уравновешивание", "4 Balancing"),
    "b_rotating": (
        "Вращающиеся массы, приведённые к пальцу кривошипа: шейка, щёки (центр их массы на радиусе ρ) и часть "
        "шатуна, отнесённая к A:",
        "The rotating masses brought to the crank pin: the pin, the webs (their mass centre on the radius ρ), and "
        "the part of the rod put in A:",
    ),
    "b_conditions": (
        "Два противовеса на радиусе R_{пр}, на расстояниях a и b от плоскости кривошипа. Статическое условие (28) и "
        "динамическое (29) дают обе массы:",
        "Two counterweights on the radius R_{cw}, at a and b from the plane of the crank. The static condition (28) "
        "and the dynamic one (29) give both masses:",
    ),
    "b_chosen": (
        "Приняты массы {one} и {two} кг. Остаётся неуравновешенной сила {force} Н и момент {moment} Н·м.",
        "The masses chosen are {one} and {two} kg. A force of {force} N and a moment of {moment} N·m stay unbalanced.",
    ),
    "b_first": (
        "Противовесы уравновешивают только вращающиеся массы. Поступательные m_{пост} = m_{3} + m_{B} = {mass} кг "
        "дают силы первого порядка m_{пост}rω²cos φ и второго λm_{пост}rω²cos 2φ вдоль цилиндра. Увеличивая "
        "противовесы на часть поступательных масс, силу первого порядка переносят с оси цилиндра поперёк неё. В "
        "таблице амплитуды найдены разложением действительной силы инерции механизма; в скобках — по формулам m·r·ω².",
        "Counterweights balance the rotating masses alone. The translating m_{tr} = m_{3} + m_{B} = {mass} kg give "
        "forces of the first order m_{tr}rω²cos φ and of the second λm_{tr}rω²cos 2φ along the cylinder. Heavier "
        "counterweights move the first-order force from the cylinder's axis across it. The amplitudes in the table "
        "are harmonics of the mechanism's true inertia force; those by the formulas m·r·ω² stand in brackets.",
    ),
    "t_first": ("Силы инерции на стойке, кН", "Inertia forces on the frame, kN"),
    "c_weights": ("Противовесы", "Counterweights"),
    "c_static": ("Σm_{пр}R_{пр}, кг·м", "Σm_{cw}R_{cw}, kg·m"),
    "c_along": ("1-й порядок вдоль", "1st order along"),
    "c_across": ("1-й порядок поперёк", "1st order across"),
    "c_second": ("2-й порядок вдоль", "2nd order along"),
    "w_none": ("нет", "none"),
    "w_rotating": ("по (30), вращающиеся массы", "by (30), rotating masses"),
    "w_chosen": ("принятые", "those chosen"),
    "w_part": ("вращающиеся и {part} поступательных", "rotating and {part} of the translating"),
    "b_second": (
        "Действительная вторая гармоника больше λm_{пост}rω²: формула отбрасывает высшие степени λ.",
        "The true second harmonic is above λm_{tr}rω², which drops higher powers of λ.",
    ),
    "f_shaking": (
        "Сила инерции механизма на стойке за оборот при разных противовесах",
        "Inertia force of the mechanism on its frame over a turn with different counterweights",
    ),
    "x_along": ("вдоль цилиндра, кН", "along the cylinder, kN"),
    "y_across": ("поперёк, кН", "across, kN"),
}
