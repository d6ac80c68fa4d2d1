// SPDX-License-Identifier: MIT
// The page's own words in English and Russian, and numbers as each language writes them.  What the core says is
// translated by the catalogue of the tool.

const RUSSIAN: Record<string, string> = {
    Undo: 'Отменить',
    Redo: 'Вернуть',
    'Open…': 'Открыть…',
    Share: 'Поделиться',
    Save: 'Сохранить',
    More: 'Ещё',
    shows: 'показано:',
    Stage: 'Сцена',
    Camera: 'Камера',
    Space: 'Пространство',
    Observer: 'Наблюдатель',
    'Observer’s picture': 'Вид наблюдателя',
    Fit: 'Всё',
    Drawer: 'Параметры',
    'Below the stage': 'Под сценой',
    'More or less room for the drawer': 'Больше или меньше места параметрам',
    Light: 'Свет',
    Matter: 'Материал',
    Place: 'Место',
    View: 'Вид',
    Lamps: 'Лампы',
    Bodies: 'Тела',
    Balance: 'Баланс',
    'Lamp on': 'Лампа включена',
    'More: name, conventions': 'Ещё: имя, соглашения, прочее',
    'Link copied': 'Ссылка скопирована',
    'The files that the scene names are not in the link.': 'Файлов, названных в сцене, в ссылке нет.',
    Link: 'Ссылка',
    'Copy link': 'Скопировать ссылку',
    'Press Ctrl+C to copy the link.': 'Нажмите Ctrl+C, чтобы скопировать ссылку.',
    'Picture of the stage': 'Изображение сцены',
    'Picture copied': 'Изображение скопировано',
    'Copy picture': 'Скопировать изображение',
    'Save picture': 'Сохранить изображение',
    'Send…': 'Отправить…',
    'Make a task': 'Составить задание',
    'The link then asks a question and judges the answer; what is hidden is only out of sight.':
        'Тогда ссылка задаёт вопрос и проверяет ответ; скрытое лишь не видно.',
    Question: 'Вопрос',
    'Empty: what the value at P is': 'Пусто: чему равно значение в P',
    'Place P': 'Место P',
    Hidden: 'Скрыто',
    'Values and shares': 'Значения и доли',
    Task: 'Задание',
    Solo: 'Только эта',
    'Aim at the probe': 'Навести на точку',
    Duplicate: 'Дублировать',
    lm: 'лм',
    lx: 'лк',
    'W/m²': 'Вт/м²',
    Illuminance: 'Освещённость',
    W: 'Вт',
    Charts: 'Графики',
    Keys: 'Клавиши',
    Everywhere: 'Везде',
    'lamp by its number': 'лампа по номеру',
    'next lamp or body': 'следующая лампа или тело',
    'move what is chosen': 'переместить выбранное',
    'add a lamp like the chosen one': 'добавить лампу, как выбранная',
    duplicate: 'дублировать',
    remove: 'удалить',
    'this lamp alone': 'только эта лампа',
    'lamp on or off': 'включить или выключить лампу',
    'why this value': 'почему такое значение',
    'keep the probe’s place as a point': 'запомнить место измерения как точку',
    'space or observer': 'пространство или наблюдатель',
    'orbit, plan, elevation': 'вокруг, план, фасад',
    'from the front': 'спереди',
    zoom: 'масштаб',
    'all in view': 'показать всё',
    exposure: 'экспозиция',
    'leave what is chosen': 'снять выбор',
    'find a parameter': 'найти параметр',
    'undo, redo': 'отменить, вернуть',
    'Find a parameter': 'Найти параметр',
    Parameters: 'Параметры',
    'Nothing is called so.': 'Ничего так не называется.',
    'to the next part of the page': 'к следующей части страницы',
    'this list': 'этот список',
    'Space bar': 'Пробел',
    Histogram: 'Гистограмма',
    pixels: 'пикселов',
    'true maximum': 'истинный максимум',
    'true minimum': 'истинный минимум',
    'Move the probe there': 'Поставить туда точку измерения',
    Grids: 'Сетки',
    Grid: 'Сетка',
    average: 'среднее по ячейкам',
    'Daylight factor': 'КЕО',
    'daylight factor': 'КЕО',
    median: 'медиана',
    'share from': 'доля от',
    'under the open sky': 'под открытым небом',
    'reflected light roughly': 'отражённый свет приближённо',
    'Reflected light, more exactly': 'Отражённый свет точнее',
    'Whole picture': 'Всё изображение',
    'Reflected light was computed roughly, for pictures; numbers are of direct light alone.':
        'Отражённый свет вычислен приближённо, для изображений; в числах только прямой свет.',
    minimum: 'минимум',
    'what the observer looks at': 'куда смотрит наблюдатель',
    'size of the screen': 'размер экрана',
    altitude: 'высота',
    azimuth: 'азимут',
    'Day of the year': 'День года',
    'Time of day': 'Время суток',
    'By date and place': 'По дате и месту',
    'By altitude and azimuth': 'По высоте и азимуту',
    Limits: 'Требования',
    kept: 'соблюдено',
    'not kept': 'нарушено',
    undecided: 'не решено',
    from: 'от',
    'average around it': 'среднее вокруг',
    'average in the background': 'среднее на фоне',
    'places and ways of looking': 'мест и направлений взгляда',
    'nothing dazzles, or all else is dark': 'ничто не слепит, или остальное темно',
    'greatest UGR': 'наибольший UGR',
    'This grid cannot be measured.': 'Эту сетку измерить нельзя.',
    'Find at P': 'Найдите в точке P',
    'As it was given': 'Как было задано',
    'Files of the scene': 'Файлы сцены',
    'Choose file…': 'Выбрать файл…',
    'Replace…': 'Заменить…',
    'the page does not have it': 'на странице его нет',
    Download: 'Скачать',
    Quantity: 'Величина',
    brightness: 'яркость',
    irradiance: 'освещённость',
    luminance: 'яркость',
    illuminance: 'освещённость',
    relative: 'отн. ед.',
    Language: 'Язык',
    Picture: 'Изображение',
    'Picture. Arrow keys move the probe, Shift moves it faster, Enter explains the value. Space selects the next lamp, Ctrl and arrows move it. Plus, minus and 0 zoom.':
        'Изображение. Стрелки двигают точку измерения, с Shift быстрее, Enter объясняет значение. Пробел выбирает следующий источник, Ctrl со стрелками двигает его. Плюс, минус и 0 меняют масштаб.',
    'Space view': 'Вид в пространстве',
    'Space view. Space selects the next thing, arrow keys and Page Up, Page Down move it; digits select lamps, V changes the view.':
        'Вид в пространстве. Пробел выбирает следующий предмет, стрелки и Page Up, Page Down двигают его; цифры выбирают лампы, V меняет вид.',
    Orbit: 'Орбита',
    Plan: 'План',
    Elevation: 'Фасад',
    Selected: 'Выбрано',
    nothing: 'ничего',
    light: 'источник',
    'aim of light': 'цель источника',
    'direction of light': 'направление источника',
    surface: 'поверхность',
    observer: 'наблюдатель',
    Value: 'Значение',
    'off every surface': 'вне поверхностей',
    'Shares of the lights': 'Доли источников',
    'Why?': 'Почему?',
    'Why this value?': 'Почему такое значение?',
    Close: 'Закрыть',
    Scale: 'Шкала',
    Colours: 'Цвета',
    Colour: 'Цвет',
    Channel: 'Канал',
    white: 'белый',
    red: 'красный',
    green: 'зелёный',
    blue: 'синий',
    'its colours, or its luminance': 'цвета или яркость',
    'colour temperature, K': 'цветовая температура, К',
    'no colour temperature': 'цветовой температуры нет',
    'nearest black body in u, v': 'ближайшее чёрное тело в u, v',
    'linear sRGB: factors, not the levels of a display': 'линейные sRGB: множители, а не уровни экрана',
    'light over more mirrors': 'свет через большее число зеркал',
    'not bounded': 'не ограничено',
    tone: 'светлота',
    grey: 'серые',
    body: 'тело',
    'not seen by the observer': 'наблюдателю не видно',
    viridis: 'viridis',
    turbo: 'turbo',
    Logarithmic: 'Логарифмическая',
    Isophotes: 'Изофоты',
    'Lock range': 'Закрепить пределы',
    From: 'От',
    To: 'До',
    Text: 'Текст',
    'Scene text (YAML)': 'Текст сцены (YAML)',
    Scene: 'Сцена',
    Add: 'Добавить',
    'lights with smaller shares': 'источников с меньшими долями',
    Remove: 'Удалить',
    Points: 'Точки',
    Point: 'Точка',
    'Add the probe’s place': 'Добавить точку измерения',
    'Arrow keys walk, Enter changes, Delete removes, Insert adds the probe’s place.':
        'Стрелки ходят по таблице, Enter меняет число, Delete удаляет точку, Insert добавляет точку измерения.',
    Section: 'Сечение',
    'Sections along x and y through the maximum.': 'Сечения вдоль x и y через максимум.',
    Curves: 'Кривые',
    values: 'значения',
    'shares of the lights, %': 'доли источников, %',
    Angle: 'Угол',
    'Fix the line': 'Закрепить линию',
    Exposure: 'Экспозиция',
    EV: 'ст.',
    'Lower end of the scale': 'Нижний конец шкалы',
    'Upper end of the scale': 'Верхний конец шкалы',
    Compare: 'Сравнить',
    'Keep as A': 'Запомнить как A',
    'Forget A': 'Забыть A',
    'Scene A': 'Сцена A',
    'A: the kept picture': 'A: запомненное',
    'B: the present picture': 'B: нынешнее',
    'A, the pixel here': 'A, пиксел здесь',
    'A and B have other numbers of pixels.': 'У A и B разное число пикселов.',
    'at most': 'не больше',
    'of the maximum of A': 'максимума A',
    'root mean square': 'среднее квадратичное',
    'Built-in scenes': 'Встроенные сцены',
    'Built-in scenes…': 'Встроенные сцены…',
    Report: 'Отчёт',
    'Open the whole page': 'Открыть страницу целиком',
    mean: 'среднее',
    maximum: 'максимум',
    'Mean irradiance of the surfaces': 'Средняя освещённость поверхностей',
    'Mean illuminance of the surfaces': 'Средняя освещённость поверхностей',
    'Balance of the flux': 'Баланс потока',
    'It does not close within its bounds: some number above is wrong.':
        'Баланс не сходится в пределах погрешностей: какое-то число выше неверно.',
    'reflected light within': 'отражённый свет с погрешностью до',
    'less exact than it should be': 'больше заданной',
    Messages: 'Сообщения',
    'The scene has errors. What is dimmed is of the last scene without errors.':
        'В сцене есть ошибки. Бледным показано то, что относится к последней сцене без ошибок.',
    'direct light alone': 'только прямой свет',
    'Reflected light is being computed': 'Вычисляется отражённый свет',
    'Reflected light was not computed: all is of direct light alone.':
        'Отражённый свет не вычислен: всё показано только для прямого света.',
    'The whole picture was not computed.': 'Полное изображение не вычислено.',
    s: 'с',
    min: 'мин',
    Stop: 'Остановить',
    Continue: 'Продолжить',
    'The value is explained when reflected light is known.':
        'Значение будет объяснено, когда станет известен отражённый свет.',
    'A scene with errors has no values to explain.': 'В сцене есть ошибки, и значений для объяснения нет.',
    'There is no file of a scene with errors.': 'Файла нет: в сцене есть ошибки.',
    'Reflected light is not known yet: there is no file without it.':
        'Отражённый свет ещё не известен, а без него файл не создаётся.',
    'The file is being made.': 'Файл создаётся.',
    'The scene has changed: the file was not made.': 'Сцена изменилась, файл не создан.',
    'There is no built-in scene of this name': 'Встроенной сцены с таким именем нет',
    'The words of that language could not be loaded. The page keeps its own.':
        'Не удалось загрузить слова этого языка. Язык страницы остаётся прежним.',
    'A number is needed here.': 'Здесь нужно число.',
    'is not a number.': '— не число.',
    'Zoom in': 'Крупнее',
    'Zoom out': 'Мельче',
    'Show all': 'Показать всё',
    'No.': '№',
    line: 'строка',
    'The core failed and was started anew. Nothing is lost.': 'Ядро дало сбой и запущено заново. Ничего не потеряно.',
    'This browser cannot run Luxel: it needs WebAssembly with SIMD (Chromium 91, Firefox 89, Safari 16.4 or newer).':
        'Этот браузер не может выполнить Luxel: нужен WebAssembly с SIMD (Chromium 91, Firefox 89, Safari 16.4 или новее).',
    'Luxel could not be loaded.': 'Не удалось загрузить Luxel.',
    'The rest of Luxel is still being loaded. What needs it comes then.':
        'Остальная часть Luxel ещё загружается. То, для чего она нужна, появится потом.',
    'The rest of Luxel could not be loaded. What needs it waits.':
        'Не удалось загрузить остальную часть Luxel. То, для чего она нужна, ждёт.',
    'Try again': 'Повторить',
    'Luxel has been renewed on the server. Load the page anew.':
        'На сервере теперь другая версия Luxel. Загрузите страницу заново.',
    'Load anew': 'Загрузить заново',
    'The link holds no scene that can be read.': 'В ссылке нет сцены, которую можно прочитать.',
    'numbers…': 'числа…',
    Apply: 'Применить',
    mm: 'мм',
    K: 'К',
    Lessons: 'Уроки',
    Chapter: 'Глава',
    Chapters: 'Главы',
    Figure: 'Рисунок',
    'Open in the full page': 'Открыть на полной странице',
    'Guess before you look': 'Сначала угадайте',
    Check: 'Проверить',
    'Check yourself': 'Проверьте себя',
    'Your answer': 'Ваш ответ',
    'Right.': 'Верно.',
    'Not so.': 'Нет.',
    'Not yet.': 'Пока нет.',
    'It is': 'Получается',
    'The core has': 'Ядро получает',
    'Right as far as it goes: give three digits.': 'Верно, но нужны три цифры.',
    'This is another convention:': 'Это другое соглашение:',
    'Type a number, such as 12.3.': 'Введите число, например 12,3.',
    'Variant of the exercise': 'Вариант упражнения',
    'Variants are numbered from 1 to': 'Варианты нумеруются от 1 до',
    Open: 'Открыть',
    'along the line': 'вдоль линии',
    m: 'м',
    size: 'размер',
    radius: 'радиус',
    height: 'высота',
    'inner angle': 'внутренний угол',
    'outer angle': 'внешний угол',
    corner: 'угол контура',
    'Drag a lamp – the light follows': 'Потяните лампу – свет последует за ней',
    'Brightness of all': 'Яркость всех',
    'Lamps chosen': 'Выбраны лампы',
    'Add another step': 'Добавить шаг',
    'Begin anew': 'Начать заново',
    'Steps before this one': 'Шагов перед этим',
    'Set up the scene and the probe, then press Share: step': 'Подготовьте сцену и точку, затем нажмите «Поделиться»: шаг',
    Back: 'Назад',
    Next: 'Далее',
    'Still life by a window': 'Натюрморт у окна',
    'On or off': 'Включить или выключить',
    'One alone': 'Снять выбор',
    'Polar diagram': 'Полярная диаграмма',
    'There is nothing to draw yet.': 'Рисовать пока нечего.',
    intensity: 'сила света',
    cd: 'кд',
    'W/sr': 'Вт/ср',
    'The core fails on this scene. Change it, or undo.':
        'Ядро не справляется с этой сценой. Измените её или отмените изменение.',
};

export type Language = 'en' | 'ru';

let language: Language = 'en';

export function setLanguage(to: Language): void {
    language = to;
    document.documentElement.lang = to;
}

export function currentLanguage(): Language {
    return language;
}

/** A text of the page in the present language. */
export function t(english: string): string {
    return language === 'ru' ? (RUSSIAN[english] ?? english) : english;
}

/** A number to so many significant digits, with the decimal sign of the language. */
export function number(value: number | null | undefined, digits = 5): string {
    if (value === null || value === undefined || !Number.isFinite(value)) return '—';
    if (value === 0) return '0';
    const size = Math.abs(value);
    const rounded = Number(value.toPrecision(digits));
    return signed(size >= 1e7 || size < 1e-4 ? rounded.toExponential() : String(rounded));
}

/** A number with so many digits behind the decimal sign of the language. */
export function fixed(value: number, digits: number): string {
    return signed((Math.abs(value) < 0.5 / 10 ** digits ? 0 : value).toFixed(digits));
}

// The decimal sign of the language, and a minus rather than a hyphen.
function signed(text: string): string {
    return (language === 'ru' ? text.replace('.', ',') : text).replace('-', '−');
}

/** A bound of an error, rounded up so that it still is one. */
export function bound(error: number, digits = 2): string {
    const rounded = Number(error.toPrecision(digits));
    const grain = 10 ** (Math.floor(Math.log10(error)) - digits + 1);
    return number(rounded < error ? rounded + grain : rounded, digits);
}

/**
 * A number with the bound of its error, "208.33 ± 0.086": no digits beyond those of the bound, which is rounded up and
 * covers the rounding of the number.
 */
export function amount([value, error]: [number, number]): string {
    const grainOf = (size: number) => 10 ** (Math.floor(Math.log10(size)) - 1);
    const rounded = error > 0 ? Math.round(value / grainOf(error)) * grainOf(error) : value;
    const shown = Number(rounded.toPrecision(7));
    return `${number(shown, 7)} ± ${bound(error + Math.abs(shown - value))}`;
}

/** An exact value; digits that are shown are exact, but for a value whose error may be seen in them, which is told. */
export function exactly(value: number, error: number): string {
    const isRough = error > 5e-6 * Math.abs(value);
    const rounded = Math.abs(Number(value.toPrecision(6)) - value);
    return `${number(value, 6)}${isRough ? ` ± ${bound(error + rounded)}` : ''}`;
}

/** What was typed as a number, with a point or a comma; null: it is none. */
export function typedNumber(text: string): number | null {
    const value = Number(text.trim().replace('−', '-').replace(',', '.'));
    return text.trim() !== '' && Number.isFinite(value) ? value : null;
}
