"""Words of the report: rod, piston pin, the summary. Key to Russian and English."""

from __future__ import annotations

ROD: dict[str, tuple[str, str]] = {
    "h_rod": ("5.5 Шатун", "5.5 Rod"),
    "s_rod": (
        "Площадь двутавра стержня F = {area} мм², W = {modulus} мм³. Сжатие наибольшее при φ = {phi_c}°, растяжение "
        "— при φ = {phi_p}°:",
        "The shank's I-section has F = {area} mm², W = {modulus} mm³. Compression is largest at φ = {phi_c}°, "
        "tension at φ = {phi_p}°:",
    ),
    "s_whip": (
        "Изгиб собственной инерцией: стержень равномерной массы на двух шарнирах, нагрузка q = m_{2}a_{⊥}/l меняется "
        "по длине линейно; наибольший момент при φ = {phi}°:",
        "Bending by its own inertia: a bar of even mass on two hinges, its load q = m_{2}a_{⊥}/l changes evenly "
        "along it; the largest moment comes at φ = {phi}°:",
    ),
    "s_rod_sum": (
        "Наибольшая сумма (φ = {phi}°) и запас по текучести:",
        "The largest sum (φ = {phi}°) and its factor against yield:",
    ),
    "s_buckling": (
        "Устойчивость: в плоскости движения концы — шарниры (μ = 1), поперёк — заделки (μ = 0,5). При гибкости Λ "
        "меньше {limit} — парабола Джонсона σ_{кр} = σ_{т}(1 − σ_{т}Λ²/4π²E), больше — Эйлер σ_{кр} = π²E/Λ².",
        "Buckling: hinged ends in the plane of motion (μ = 1), fixed ones across it (μ = 0.5). Below a slenderness Λ "
        "of {limit} Johnson's parabola σ_{cr} = σ_{y}(1 − σ_{y}Λ²/4π²E) holds, above it Euler's σ_{cr} = π²E/Λ².",
    ),
    "t_buckling": ("Устойчивость стержня шатуна", "Buckling of the rod's shank"),
    "c_plane": ("Плоскость", "Plane"),
    "b_plane_0": ("движения", "of motion"),
    "b_plane_1": ("поперечная", "across it"),
    "s_n_ok": ("Требуется n ≥ {need}; выполнено.", "Required n ≥ {need}; it holds."),
    "s_n_bad": ("Требуется n ≥ {need}; не выполнено.", "Required n ≥ {need}; it does not hold."),
    "h_pin": ("5.6 Поршневой палец", "5.6 Piston pin"),
    "s_pin": (
        "Наибольшая сила на пальце (газы и инерция поршня) {force} Н при φ = {phi}°. Втулка шатуна давит равномерно, "
        "бобышки — по треугольнику, убывая к концам пальца, поэтому:",
        "The largest force on the pin (gas and the piston's inertia) is {force} N at φ = {phi}°. The rod's bush "
        "presses evenly, the bosses as triangles that fall to zero at the pin's ends, so:",
    ),
    "s_pin_stress": (
        "Напряжения изгиба и среза полого пальца, α = d_{0}/d = {ratio}:",
        "Bending and shear of the hollow pin, α = d_{0}/d = {ratio}:",
    ),
    "s_pin_sum": (
        "Наибольшие σ и τ не встречаются в одной точке; расчётное — большее из σ и 2τ, {stress} МПа, запас по "
        "текучести {n}. Давления во втулке и в бобышках:",
        "The largest σ and τ do not meet in one point; what counts is the larger of σ and 2τ, {stress} MPa, with a "
        "factor of {n} against yield. Pressures in the bush and the bosses:",
    ),
    "s_pressure_ok": ("Допускаются {bush} и {boss} МПа; выполнено.", "Allowed: {bush} and {boss} MPa; they hold."),
    "s_pressure_bad": (
        "Допускаются {bush} и {boss} МПа; не выполнено.",
        "Allowed: {bush} and {boss} MPa; they do not hold.",
    ),
    "h_summary": ("6 Итоги", "6 Summary"),
    "t_summary": ("Проверки", "Checks"),
    "c_check": ("Проверка", "Check"),
    "c_found": ("Найдено", "Found"),
    "c_needed": ("Требуется", "Required"),
    "c_verdict": ("Итог", "Verdict"),
    "yes": ("да", "yes"),
    "no": ("нет", "no"),
    "c_static_shaft": ("вал, запас по текучести", "shaft, factor against yield"),
    "c_fatigue_shaft": ("вал, запас выносливости", "shaft, fatigue factor"),
    "c_rod_static": ("шатун, запас по текучести", "rod, factor against yield"),
    "c_rod_buckling": ("шатун, запас устойчивости", "rod, buckling factor"),
    "c_pin_static": ("палец, запас по текучести", "piston pin, factor against yield"),
    "c_pin_bush": ("палец, давление во втулке, МПа", "piston pin, pressure in the bush, MPa"),
    "c_pin_boss": ("палец, давление в бобышках, МПа", "piston pin, pressure in the bosses, MPa"),
    "t_wrong": ("Ошибки исходного текста", "Errors of the source text"),
    "c_formula": ("Формула", "Formula"),
    "c_error": ("Что не так", "What is wrong"),
    "e_3": (
        "верна лишь при ω = const, слагаемые с ε пропущены",
        "holds for steady ω only, the terms with ε are missing",
    ),
    "e_5": (
        "ω названа ускорением; (5), (7) без модулей и 0·∞ при cos φ = 0",
        "ω called an acceleration; (5), (7) lack moduli, 0·∞ at cos φ = 0",
    ),
    "e_20": (
        "знак теоремы Штейнера; множитель 4/9 вместо 2/9; AC = l/3 против 0,3l",
        "sign of the parallel-axis theorem; 4/9 instead of 2/9; AC = l/3 against 0.3l",
    ),
    "e_22": ("нет момента на кривошипе; R_{B} = G_{3} неверно", "no torque on the crank; R_{B} = G_{3} is wrong"),
    "e_24": ("пропущена вертикальная сила в B", "the vertical force in B is missing"),
    "e_32": ("знак последнего слагаемого A′", "sign of the last term of A′"),
    "e_35": (
        "ε — и угловое ускорение, и масштабный фактор; l — и шатун, и пролёт",
        "ε is both angular acceleration and size factor, l both rod and span",
    ),
}
