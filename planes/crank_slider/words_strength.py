"""Words of the report: balancing, strength, the list of corrections. Key to Russian and English."""

STRENGTH: dict[str, tuple[str, str]] = {
    "h_balancing": ("4 Уравновешивание", "4 Balancing"),
    "b_rotating": (
        "Вращающиеся массы, приведённые к пальцу кривошипа: шейка, щёки (центр их массы на радиусе ρ) и часть шатуна, "
        "отнесённая к A:",
        "The rotating masses brought to the crank pin: the pin, the webs (their mass centre on the radius ρ), and the part "
        "of the rod put in A:",
    ),
    "b_conditions": (
        "Два противовеса на радиусе R_{пр}, на расстояниях a и b от плоскости кривошипа. Статическое условие (28) и "
        "динамическое (29) дают обе массы:",
        "Two counterweights on the radius R_{cw}, at a and b from the plane of the crank. The static condition (28) and "
        "the dynamic one (29) give both masses:",
    ),
    "b_chosen": (
        "Приняты массы {one} и {two} кг. Остаётся неуравновешенной сила {force} Н и момент {moment} Н·м.",
        "The masses chosen are {one} and {two} kg. A force of {force} N and a moment of {moment} N·m stay unbalanced.",
    ),
    "b_first": (
        "Противовесы уравновешивают только вращающиеся массы. Поступательные m_{пост} = m_{3} + m_{B} = {mass} кг дают силы "
        "первого порядка m_{пост}rω²cos φ и второго λm_{пост}rω²cos 2φ вдоль цилиндра. Увеличивая противовесы на часть "
        "поступательных масс, силу первого порядка переносят с оси цилиндра поперёк неё. В таблице амплитуды найдены "
        "разложением действительной силы инерции механизма; в скобках — по формулам m·r·ω².",
        "Counterweights balance the rotating masses alone. The translating m_{tr} = m_{3} + m_{B} = {mass} kg give forces "
        "of the first order m_{tr}rω²cos φ and of the second λm_{tr}rω²cos 2φ along the cylinder. Heavier counterweights "
        "move the first-order force from the cylinder's axis across it. The amplitudes in the table are harmonics of the "
        "mechanism's true inertia force; those by the formulas m·r·ω² stand in brackets.",
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
        "σ_{u}, σ_{y} are the least values of GOST 1050 (normalised) and GOST 4543 (hardened and tempered); a real part is "
        "checked by its certificate. Fatigue limits not given are estimates: σ_{−1} = 0.43σ_{u} (carbon steels), 0.35σ_{u} "
        "+ 120 (alloy steels), τ_{−1} = 0.58σ_{−1}; ψ_{σ} = 0.02 + 2·10⁻⁴σ_{u}, ψ_{τ} = 0.5ψ_{σ}.",
    ),
    "h_shaft": ("5.2 Коленчатый вал: опоры и эпюры", "5.2 Crankshaft: bearings and diagrams"),
    "s_shaft": (
        "Вал — ломаный брус на двух опорах; нагрузки сосредоточены, мощность снимается у опоры B. z направлена от оси вала "
        "к пальцу, y — по ходу пальца; N_{c1} = −K, P_{t1} = T. Инерция вращающейся части шатуна уже входит в N_{c1}, "
        "поэтому Φ — инерция одного колена, по половине на щёку.",
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
        "В напечатанной (32) последнее слагаемое A′ стоит с минусом. Моменты относительно B дают "
        "A′l = (Φ − Φ_{пр})(l − m) + N_{c1}n + (Φ − Φ_{пр})m: обе щёки нагружены одинаково, поэтому знак — плюс (либо в "
        "скобках обратный порядок, Φ_{пр} − Φ). Буквой l здесь обозначен пролёт вала, а не шатун, A и B — опоры, а не "
        "шарниры; в этом отчёте пролёт L.",
        "In (32) as printed the last term of A′ has a minus. Moments about B give A′l = (Φ − Φ_{cw})(l − m) + N_{c1}n + "
        "(Φ − Φ_{cw})m: both webs carry the same load, so the sign is plus (or the order in the bracket is Φ_{cw} − Φ). "
        "The letter l is the shaft's span here, not the rod, and A, B are bearings, not hinges; this report writes L.",
    ),
    "s_case": (
        "Наиболее опасны два положения: {case_k} — наибольшая нормальная сила, φ = {phi_k}°; {case_t} — наибольшая "
        "касательная сила, φ = {phi_t}°.",
        "Two positions are the most dangerous: {case_k}, the largest normal force, φ = {phi_k}°; {case_t}, the largest "
        "tangential one, φ = {phi_t}°.",
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
        "Круглые сечения — по третьей гипотезе (33). В щеке напряжения от изгиба в двух плоскостях, растяжения и кручения "
        "сложены так, будто они встречаются в одной точке (запас в надёжную сторону). Щёки текст не считает.",
        "Round sections follow the third theory (33). In a web the stresses of bending in both planes, tension and torsion "
        "are added as if they met in one point (on the safe side). The text does not calculate the webs.",
    ),
    "t_static": ("Напряжения в сечениях: моменты, Н·м; напряжения, МПа", "Stresses of the sections: moments, N·m; stresses, MPa"),
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
        "Для каждого сечения по циклу прослежено напряжение в каждой точке его края и взята точка с наименьшим запасом; "
        "σ_{a}, σ_{m}, τ_{a}, τ_{m} — амплитуды и средние:",
        "In each section the stress of every point of its edge is followed over the cycle, and the point with the least "
        "factor is taken; σ_{a}, σ_{m}, τ_{a}, τ_{m} are amplitudes and means:",
    ),
    "t_fatigue": ("Запасы выносливости", "Fatigue factors"),
    "s_fatigue_at": ("Наименьший запас — {section}:", "The least factor, the {section}:"),
    "s_limits": ("Требуется {low} ≤ n ≤ {high}.", "Required: {low} ≤ n ≤ {high}."),
    "s_fat_ok": ("Наименьший запас {n} — в этих пределах.", "The least factor, {n}, lies within."),
    "s_fat_low": ("Наименьший запас {n} — меньше требуемого: вал не проходит.", "The least factor, {n}, is too low: the shaft fails."),
    "s_fat_high": (
        "Наименьший запас {n} — выше верхнего предела: прочность обеспечена, но вал можно облегчить.",
        "The least factor, {n}, is above the upper limit: strong enough, but the shaft could be lighter.",
    ),
    "s_fat_reserve": (
        "Выше верхнего предела: {names}; эти сечения имеют лишний запас.",
        "Above the upper limit: {names}; these sections have more than they need.",
    ),
    "m_eps": (
        "В (35) буква ε — масштабный фактор, а выше ε — угловое ускорение; коэффициенты ε_{σ} и ε_{τ} у изгиба и кручения "
        "разные, текст пишет один.",
        "In (35) ε is the size factor, above it was an angular acceleration; ε_{σ} and ε_{τ} differ in bending and torsion, "
        "the text writes one.",
    ),
    "h_rod": ("5.5 Шатун", "5.5 Rod"),
    "s_rod": (
        "Площадь двутавра стержня F = {area} мм², W = {modulus} мм³. Сжатие наибольшее при φ = {phi_c}°, растяжение — при "
        "φ = {phi_p}°:",
        "The shank's I-section has F = {area} mm², W = {modulus} mm³. Compression is largest at φ = {phi_c}°, tension at "
        "φ = {phi_p}°:",
    ),
    "s_whip": (
        "Изгиб собственной инерцией: стержень равномерной массы на двух шарнирах, нагрузка q = m_{2}a_{⊥}/l меняется по "
        "длине линейно; наибольший момент при φ = {phi}°:",
        "Bending by its own inertia: a bar of even mass on two hinges, its load q = m_{2}a_{⊥}/l changes evenly along it; "
        "the largest moment comes at φ = {phi}°:",
    ),
    "s_rod_sum": ("Наибольшая сумма (φ = {phi}°) и запас по текучести:", "The largest sum (φ = {phi}°) and its factor against yield:"),
    "s_buckling": (
        "Устойчивость: в плоскости движения концы — шарниры (μ = 1), поперёк — заделки (μ = 0,5). При гибкости Λ меньше "
        "{limit} — парабола Джонсона σ_{кр} = σ_{т}(1 − σ_{т}Λ²/4π²E), больше — Эйлер σ_{кр} = π²E/Λ².",
        "Buckling: hinged ends in the plane of motion (μ = 1), fixed ones across it (μ = 0.5). Below a slenderness Λ of "
        "{limit} Johnson's parabola σ_{cr} = σ_{y}(1 − σ_{y}Λ²/4π²E) holds, above it Euler's σ_{cr} = π²E/Λ².",
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
        "The largest force on the pin (gas and the piston's inertia) is {force} N at φ = {phi}°. The rod's bush presses "
        "evenly, the bosses as triangles that fall to zero at the pin's ends, so:",
    ),
    "s_pin_stress": ("Напряжения изгиба и среза полого пальца, α = d_{0}/d = {ratio}:", "Bending and shear of the hollow pin, α = d_{0}/d = {ratio}:"),
    "s_pin_sum": (
        "Наибольшие σ и τ не встречаются в одной точке; расчётное — большее из σ и 2τ, {stress} МПа, запас по текучести "
        "{n}. Давления во втулке и в бобышках:",
        "The largest σ and τ do not meet in one point; what counts is the larger of σ and 2τ, {stress} MPa, with a factor "
        "of {n} against yield. Pressures in the bush and the bosses:",
    ),
    "s_pressure_ok": ("Допускаются {bush} и {boss} МПа; выполнено.", "Allowed: {bush} and {boss} MPa; they hold."),
    "s_pressure_bad": ("Допускаются {bush} и {boss} МПа; не выполнено.", "Allowed: {bush} and {boss} MPa; they do not hold."),
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
    "c_unbalanced": ("остаточная сила вращающихся масс, Н", "unbalanced force of rotating masses, N"),
    "t_wrong": ("Ошибки исходного текста", "Errors of the source text"),
    "c_formula": ("Формула", "Formula"),
    "c_error": ("Что не так", "What is wrong"),
    "e_3": ("верна лишь при ω = const, слагаемые с ε пропущены", "holds for steady ω only, the terms with ε are missing"),
    "e_5": ("ω названа ускорением; (5), (7) без модулей и 0·∞ при cos φ = 0", "ω called an acceleration; (5), (7) lack moduli, 0·∞ at cos φ = 0"),
    "e_20": ("знак теоремы Штейнера; множитель 4/9 вместо 2/9; AC = l/3 против 0,3l", "sign of the parallel-axis theorem; 4/9 instead of 2/9; AC = l/3 against 0.3l"),
    "e_22": ("нет момента на кривошипе; R_{B} = G_{3} неверно", "no torque on the crank; R_{B} = G_{3} is wrong"),
    "e_24": ("пропущена вертикальная сила в B", "the vertical force in B is missing"),
    "e_32": ("знак последнего слагаемого A′", "sign of the last term of A′"),
    "e_35": ("ε — и угловое ускорение, и масштабный фактор; l — и шатун, и пролёт", "ε is both angular acceleration and size factor, l both rod and span"),
}
