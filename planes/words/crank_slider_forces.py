"""Words of the report: kinetostatics. Key to Russian and English."""

FORCES: dict[str, tuple[str, str]] = {
    "h_forces": ("3 Кинетостатика", "3 Kinetostatics"),
    "h_gas": ("3.1 Давление газов", "3.1 Gas pressure"),
    "s_gas": (
        "Индикаторная диаграмма задана таблицей по ходам ({strokes} в цикле); между точками — монотонный кубический "
        "сплайн, он не выходит за давления соседних точек. Сила на поршень, положительная к кривошипу, p_{0} = {p0} "
        "МПа:",
        "The indicator diagram is a table of the strokes ({strokes} in a cycle); between its points runs a monotone "
        "cubic that never leaves the neighbouring pressures. The force on the piston, positive towards the crank, "
        "p_{0} = {p0} MPa:",
    ),
    "s_gas_at": (
        "При φ = {phi}° p = {p} МПа. Наибольшее давление {top} МПа при φ = {at}°.",
        "At φ = {phi}° p = {p} MPa. The largest pressure, {top} MPa, comes at φ = {at}°.",
    ),
    "f_gas": ("Давление газов по углу поворота", "Gas pressure over the crank angle"),
    "f_pv": ("Индикаторная диаграмма: давление по пути поршня", "Indicator diagram: pressure over the piston's path"),
    "y_p": ("p, МПа", "p, MPa"),
    "x_path": (
        "путь поршня от верхней мёртвой точки, доли хода",
        "piston path from top dead centre, parts of the stroke",
    ),
    "h_mass": ("3.2 Приведение масс шатуна", "3.2 Replaced masses of the rod"),
    "s_two": (
        "Две точки A и B сохраняют массу и центр масс, но не момент инерции:",
        "Two points A and B keep the mass and the mass centre, but not the moment of inertia:",
    ),
    "s_two_err": (
        "Момент инерции двух точек отличается на {percent} % ({sign} действительного); в момент сил инерции шатуна "
        "это вносит ошибку до {moment} Н·м. Три точки A, C, B сохраняют и момент инерции:",
        "The moment of inertia of two points is off by {percent} % ({sign} the true one); this puts an error of up "
        "to {moment} N·m into the rod's inertia couple. Three points A, C, B keep the moment of inertia too:",
    ),
    "s_more": ("больше", "above"),
    "s_less": ("меньше", "below"),
    "s_three_neg": (
        "Масса в C вышла отрицательной: шатун «короче» двухмассового, замена остаётся верной как расчётный приём.",
        "The mass in C comes out negative; the replacement stays right as a way of calculating.",
    ),
    "s_simple": (
        "Силы ниже найдены с действительным шатуном (m_{2}, J_{C}). По обычным формулам двухмассовой замены, без "
        "весов и трения, P = P_{г} + (m_{3} + m_{B})a_{B}, T = P·sin(φ + β)/cos β, наибольшее T отличалось бы на {t} "
        "%, наибольшее N — на {n} %.",
        "The forces below are found with the true rod (m_{2}, J_{C}). By the usual formulas of two replaced masses, "
        "with no weights and no friction, P = P_{g} + (m_{3} + m_{B})a_{B}, T = P·sin(φ + β)/cos β, the largest T "
        "would differ by {t} %, the largest N by {n} %.",
    ),
    "h_inertia": ("3.3 Силы инерции", "3.3 Inertia forces"),
    "m_20": (
        "В (20) теорема Штейнера применена с обратным знаком: J_{C} = J_{A} − m·AC², а не плюс; при напечатанных "
        "J_{A} = ml²/3 и AC = l/3 вышло бы 2/9·ml², а не 4/9·ml², и (21) ошибочна вдвое. Кроме того, везде в тексте "
        "AC = 0,3l, а здесь l/3; и J_{A} = ml²/3 относится к однородному стержню, у которого C посередине и J_{C} = "
        "ml²/12. По (20) было бы J_{C} = {printed} кг·м²; в расчёте взято заданное {true} кг·м².",
        "In (20) the parallel-axis theorem has the wrong sign: J_{C} = J_{A} − m·AC², not plus; with the printed "
        "J_{A} = ml²/3 and AC = l/3 it gives 2/9·ml², not 4/9·ml², so (21) is twice too large. Besides, AC is 0.3l "
        "everywhere else and l/3 here, and J_{A} = ml²/3 belongs to an even bar with C in its middle and J_{C} = "
        "ml²/12. By (20) J_{C} would be {printed} kg·m²; the calculation takes the given {true} kg·m².",
    ),
    "h_balance": ("3.4 Уравнения кинетостатики", "3.4 Equations of kinetostatics"),
    "s_balance": (
        "Группа шатун — ползун: моменты относительно A дают реакцию направляющей N (вверх), суммы сил — силы в "
        "шарнирах. P_{п} — сила вдоль оси на ползуне (газы, инерция, трение), положительная к кривошипу; S сжимает "
        "шатун у B; T и K действуют на палец кривошипа: T по ходу вращения, K к оси вала.",
        "The group of rod and slider: moments about A give the guide's push N (up), sums of forces the hinges. P_{p} "
        "is the force along the axis on the slider (gas, inertia, friction), positive towards the crank; S squeezes "
        "the rod at B; T and K act on the crank pin: T along its motion, K towards the shaft's axis.",
    ),
    "s_friction": (
        "Трение f∣N∣ направлено против скорости; знак N выбран тот, при котором уравнение выполняется.",
        "Friction f∣N∣ opposes the velocity; the sign of N is the one that satisfies the equation.",
    ),
    "m_22": (
        "В (22) сумма моментов относительно O не содержит момента на кривошипе, без которого вал не в равновесии; "
        "R_{B} надо искать из группы шатун — ползун. Здесь при φ = {phi}° по (22) R_{B} = {printed} Н, верно {true} "
        "Н. Дальше текст принимает R_{B} = G_{3}, что противоречит и (22), и (23): без массы шатуна R_{B} = G_{3} + "
        "P_{п}·tg β.",
        "In (22) the moments about O lack the torque on the crank, without which the shaft is in no equilibrium; "
        "R_{B} must come from the group of rod and slider. Here, at φ = {phi}°, (22) gives R_{B} = {printed} N, the "
        "truth is {true} N. Later the text takes R_{B} = G_{3}, against both (22) and (23): with a massless rod "
        "R_{B} = G_{3} + P_{p}·tan β.",
    ),
    "m_24": (
        "В (24) для шатуна нет вертикальной силы в шарнире B, поэтому ошибочны (25) и (26). Здесь при φ = {phi}°: T "
        "= {t_printed} Н вместо {t_true} Н, K = {k_printed} Н вместо {k_true} Н. У текста P_{t} = −T, N_{C} = −K "
        "(силы на шатун).",
        "In (24) the rod lacks the vertical force in the hinge B, so (25) and (26) are wrong. Here, at φ = {phi}°: T "
        "= {t_printed} N instead of {t_true} N, K = {k_printed} N instead of {k_true} N. The text's P_{t} = −T, "
        "N_{C} = −K (forces on the rod).",
    ),
    "h_cycle": ("3.5 Силы за цикл", "3.5 Forces over the cycle"),
    "t_forces": (
        "Силы за цикл: p, МПа; силы, кН; M — момент на кривошипе, Н·м",
        "Forces over the cycle: p, MPa; forces, kN; M, the torque on the crank, N·m",
    ),
    "s_equal": (
        "Те же силы найдены общим расчётом планов сил (моменты по плечам, многоугольники) при {count} положениях "
        "цикла. Наибольшее расхождение сил {forces} наибольшей силы, моментов {torque}, рычага Жуковского {lever}.",
        "The same forces are found by the general force plans (moments by arms, polygons) in {count} positions of "
        "the cycle. The largest difference of forces is {forces} of the largest force, of torques {torque}, of "
        "Zhukovsky's lever {lever}.",
    ),
    "f_P": (
        "Силы вдоль оси цилиндра: газы, инерция поршня, сумма с трением",
        "Forces along the cylinder: gas, the piston's inertia, sum with friction",
    ),
    "f_NS": ("Сила вдоль шатуна S и давление на направляющую N", "Force along the rod S and push of the guide N"),
    "f_TK": (
        "Касательная T и нормальная K силы на пальце кривошипа",
        "Tangential T and normal K force on the crank pin",
    ),
    "f_polar": (
        "Полярная диаграмма нагрузки на шатунную шейку в осях кривошипа: вправо от оси вала, вверх по ходу вращения; "
        "точки через 30°, у некоторых φ",
        "Polar diagram of the crank pin's load in the crank's axes: right, away from the shaft; up, along the "
        "motion; points every 30°, some with their φ",
    ),
    "x_out": ("−K, кН", "−K, kN"),
    "y_T": ("T, кН", "T, kN"),
    "y_kN": ("кН", "kN"),
    "l_gas": ("газы", "gas"),
    "l_inertia": ("инерция", "inertia"),
    "l_sum": ("сумма", "sum"),
    "l_mean": ("средний", "mean"),
    "s_bearing": (
        "Реакция стойки на кривошип (обе опоры вместе) наибольшая {force} кН при φ = {phi}°; её доли на опорах A и B "
        "— в разделе прочности. Наибольшая нагрузка шатунной шейки {pin} кН при φ = {pin_phi}°, средняя {mean} кН.",
        "The frame's reaction on the crank (both bearings together) is largest, {force} kN, at φ = {phi}°; how "
        "bearings A and B share it stands under strength. The largest load of the crank pin is {pin} kN at φ = "
        "{pin_phi}°, the mean {mean} kN.",
    ),
    "h_fplans": ("3.6 Планы сил", "3.6 Force plans"),
    "f_force": ("Планы сил группы и кривошипа при φ = {phi}°", "Force plans of the group and the crank at φ = {phi}°"),
    "h_torque": ("3.7 Крутящий момент и маховик", "3.7 Torque and flywheel"),
    "s_torque": (
        "Момент на кривошипе M = T·r вместе с весом кривошипа. За цикл работа момента равна работе газов без работы "
        "трения (инерция и веса за цикл работы не дают):",
        "The torque on the crank is M = T·r with the crank's weight. Over the cycle its work is that of the gas less "
        "the friction (inertia and weights do none in a cycle):",
    ),
    "s_torque_var": (
        "Момент на кривошипе M = T·r вместе с весом и инерцией кривошипа. Кинетическая энергия в конце цикла та же, "
        "что в начале, поэтому работа момента равна работе газов без работы трения:",
        "The torque on the crank is M = T·r with the crank's weight and inertia. The kinetic energy at the end of "
        "the cycle is that of its start, so the torque's work is that of the gas less the friction:",
    ),
    "s_uneven": (
        "Неравномерность момента (M_{наиб} − M_{наим})/M_{ср} = {uneven}. Избыточная работа — размах ∫(M − "
        "M_{ср})dφ; маховик для неравномерности хода [δ] = {allowed}:",
        "The unevenness of torque (M_{max} − M_{min})/M_{m} = {uneven}. The excess work is the range of ∫(M − "
        "M_{m})dφ; the flywheel for an unevenness of speed [δ] = {allowed}:",
    ),
    "s_negative": (
        "Средний момент отрицателен: за цикл механизм потребляет энергию (компрессор).",
        "The mean torque is negative: over the cycle the mechanism takes energy (a compressor).",
    ),
    "f_torque": ("Крутящий момент за цикл и его среднее значение", "Torque over the cycle and its mean"),
    "f_excess": ("Избыточная работа ∫(M − M_{ср})dφ", "Excess work ∫(M − M_{m})dφ"),
    "y_M": ("M, Н·м", "M, N·m"),
    "y_J": ("Дж", "J"),
}
