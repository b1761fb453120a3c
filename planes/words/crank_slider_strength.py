"""Words of the report: strength of the crankshaft. Key to Russian and English."""

from __future__ import annotations

STRENGTH: dict[str, tuple[str, str]] = {
    "h_strength": ("5 Прочность", "5 Strength"),
    "h_material": ("5.1 Материалы", "5.1 Materials"),
    "t_material": ("Стали, МПа", "Steels, MPa"),
    "c_part": ("Деталь", "Part"),
    "c_steel": ("Сталь", "Steel"),
    "p_shaft": ("коленчатый вал", "crankshaft"),
    "p_rod": ("шатун", "rod"),
    "p_piston_pin": ("поршневой палец", "piston pin"),
    "s_material": (
        "σ_{в}, σ_{т} — наименьшие значения ГОСТ 1050 (нормализация) и ГОСТ 4543 (закалка и отпуск), для изделия их "
        "проверяют по сертификату. Не заданные пределы выносливости оценены: σ_{−1} = 0,43σ_{в} (углеродистые), "
        "0,35σ_{в} + 120 (легированные), τ_{−1} = 0,58σ_{−1}; ψ_{σ} = 0,02 + 2·10⁻⁴σ_{в}, ψ_{τ} = 0,5ψ_{σ}.",
        "σ_{u}, σ_{y} are the least values of GOST 1050 (normalised) and GOST 4543 (hardened and tempered); a real "
        "part is checked by its certificate. Fatigue limits not given are estimates: σ_{−1} = 0.43σ_{u} (carbon "
        "steels), 0.35σ_{u} + 120 (alloy steels), τ_{−1} = 0.58σ_{−1}; ψ_{σ} = 0.02 + 2·10⁻⁴σ_{u}, ψ_{τ} = 0.5ψ_{σ}.",
    ),
    "h_shaft": ("5.2 Коленчатый вал: опоры и эпюры", "5.2 Crankshaft: bearings and diagrams"),
    "s_shaft": (
        "Вал — ломаный брус на двух опорах; нагрузки сосредоточены, мощность снимается у опоры B. z направлена от "
        "оси вала к пальцу, y — по ходу пальца; N_{c1} = −K, P_{t1} = T. Инерция вращающейся части шатуна уже входит "
        "в N_{c1}, поэтому Φ — инерция одного колена, по половине на щёку.",
        "The shaft is a broken bar on two supports; loads are concentrated, power is taken off at B. z runs from the "
        "shaft's axis to the pin, y along its motion; N_{c1} = −K, P_{t1} = T. The rod's rotating part is in N_{c1} "
        "already, so Φ is the inertia of the crank alone, half of it on each web.",
    ),
    "f_sketch": ("Расчётная схема вала: a = {a} м, b = {b} м", "The shaft as calculated: a = {a} m, b = {b} m"),
    "s_reactions": (
        "Из сумм сил и моментов (31), Φ_{1} и Φ_{2} — силы противовесов:",
        "From the sums of forces and moments (31), Φ_{1} and Φ_{2} being the counterweights' forces:",
    ),
    "m_32": (
        "В напечатанной (32) последнее слагаемое A′ стоит с минусом. Моменты относительно B дают A′l = (Φ − "
        "Φ_{пр})(l − m) + N_{c1}n + (Φ − Φ_{пр})m: обе щёки нагружены одинаково, поэтому знак — плюс (либо в скобках "
        "обратный порядок, Φ_{пр} − Φ). Буквой l здесь обозначен пролёт вала, а не шатун, A и B — опоры, а не "
        "шарниры; в этом отчёте пролёт L.",
        "In (32) as printed the last term of A′ has a minus. Moments about B give A′l = (Φ − Φ_{cw})(l − m) + "
        "N_{c1}n + (Φ − Φ_{cw})m: both webs carry the same load, so the sign is plus (or the order in the bracket is "
        "Φ_{cw} − Φ). The letter l is the shaft's span here, not the rod, and A, B are bearings, not hinges; this "
        "report writes L.",
    ),
    "s_case": (
        "Наиболее опасны два положения: {case_k} — наибольшая нормальная сила, φ = {phi_k}°; {case_t} — наибольшая "
        "касательная сила, φ = {phi_t}°.",
        "Two positions are the most dangerous: {case_k}, the largest normal force, φ = {phi_k}°; {case_t}, the "
        "largest tangential one, φ = {phi_t}°.",
    ),
    "s_case_at": ("Случай {case}, φ = {phi}°:", "Case {case}, φ = {phi}°:"),
    "f_moments": ("Эпюры моментов вдоль вала, случай {case}", "Moments along the shaft, case {case}"),
    "x_shaft": ("расстояние от опоры A, м", "distance from bearing A, m"),
    "l_Mz": ("изгиб в плоскости кривошипа", "bending in the crank's plane"),
    "l_My": ("изгиб поперёк неё", "bending across it"),
    "l_Mx": ("кручение", "torsion"),
    "y_Nm": ("Н·м", "N·m"),
    "h_static": ("5.3 Статическая прочность вала", "5.3 Static strength of the shaft"),
    "s_static": (
        "Круглые сечения — по третьей гипотезе (33). В щеке напряжения от изгиба в двух плоскостях, растяжения и "
        "кручения сложены так, будто они встречаются в одной точке (запас в надёжную сторону). Щёки текст не считает.",
        "Round sections follow the third theory (33). In a web the stresses of bending in both planes, tension and "
        "torsion are added as if they met in one point (on the safe side). The text does not calculate the webs.",
    ),
    "t_static": (
        "Напряжения в сечениях: моменты, Н·м; напряжения, МПа",
        "Stresses of the sections: moments, N·m; stresses, MPa",
    ),
    "c_section": ("Сечение, случай", "Section, case"),
    "x_journal_A": ("коренная шейка A", "journal A"),
    "x_journal_B": ("коренная шейка B", "journal B"),
    "x_web_A": ("щека A", "web A"),
    "x_web_B": ("щека B", "web B"),
    "x_crankpin": ("шатунная шейка", "crank pin"),
    "x_rod": ("стержень шатуна", "rod's shank"),
    "s_dangerous": (
        "Опасное сечение за весь цикл — {section}, φ = {phi}°. Допускаемое напряжение [σ] = σ_{т}/{n}:",
        "The most loaded section over the cycle is the {section}, φ = {phi}°. The allowed stress is [σ] = σ_{y}/{n}:",
    ),
    "s_ok": ("Условие прочности (34) выполнено.", "The condition of strength (34) holds."),
    "s_bad": (
        "Условие прочности (34) не выполнено: увеличьте сечение или возьмите более прочную сталь.",
        "The condition of strength (34) does not hold: enlarge the section or take a stronger steel.",
    ),
    "h_fatigue": ("5.4 Выносливость вала", "5.4 Fatigue of the shaft"),
    "s_fatigue": (
        "Для каждого сечения по циклу прослежено напряжение в каждой точке его края и взята точка с наименьшим "
        "запасом; σ_{a}, σ_{m}, τ_{a}, τ_{m} — амплитуды и средние:",
        "In each section the stress of every point of its edge is followed over the cycle, and the point with the "
        "least factor is taken; σ_{a}, σ_{m}, τ_{a}, τ_{m} are amplitudes and means:",
    ),
    "t_fatigue": ("Запасы выносливости", "Fatigue factors"),
    "s_fatigue_at": ("Наименьший запас — {section}:", "The least factor, the {section}:"),
    "s_limits": ("Требуется {low} ≤ n ≤ {high}.", "Required: {low} ≤ n ≤ {high}."),
    "s_fat_ok": ("Наименьший запас {n} — в этих пределах.", "The least factor, {n}, lies within."),
    "s_fat_low": (
        "Наименьший запас {n} — меньше требуемого: вал не проходит.",
        "The least factor, {n}, is too low: the shaft fails.",
    ),
    "s_fat_high": (
        "Наименьший запас {n} — выше верхнего предела: прочность обеспечена, но вал можно облегчить.",
        "The least factor, {n}, is above the upper limit: strong enough, but the shaft could be lighter.",
    ),
    "s_fat_reserve": (
        "Выше верхнего предела: {names}; эти сечения имеют лишний запас.",
        "Above the upper limit: {names}; these sections have more than they need.",
    ),
    "m_eps": (
        "В (35) буква ε — масштабный фактор, а выше ε — угловое ускорение; коэффициенты ε_{σ} и ε_{τ} у изгиба и "
        "кручения разные, текст пишет один.",
        "In (35) ε is the size factor, above it was an angular acceleration; ε_{σ} and ε_{τ} differ in bending and "
        "torsion, the text writes one.",
    ),
}
