/* SPDX-License-Identifier: MIT */
/*
 * The words of the field: what somebody types who knows lighting, but not Luxel.  The words themselves stand here in
 * both languages, as students look up what their course says whatever the language of their terminal is.
 */
#include "help_words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"
#include "text.h"

struct entry {
    const char *words; /* in lower case, with bars between them */
    const char *meaning;
    const char *see; /* command lines, with bars between them */
};

static const struct entry entries[] = {
    {"luminance|nit|nits|cd/m2|cd/m²|cd/m^2|яркость|кд/м²|кд/м2|нит",
     N_("Luminance, in cd/m²: how bright a surface is in a direction. It is the quantity brightness of a scene in "
        "photometric units, and has the unit cd/m² where all materials have over_pi: true and all lights are "
        "inverse-square, distant or ambient."),
     "luxel render --quantity luminance|luxel help brightness|luxel help units|luxel help over_pi"},
    {"brightness",
     N_("Brightness: what the material makes of the light, summed over all lights, as the exercise defines it. With "
        "over_pi: true it is the radiance or, in photometric units, the luminance; with attenuation: none it has the "
        "unit of an intensity, as no distance enters."),
     "luxel render --quantity brightness|luxel help material|luxel help over_pi|luxel help attenuation"},
    {"illuminance|lux|lx|foot-candle|footcandle|освещённость|освещенность|люкс|лк",
     N_("Illuminance, in lux (lx): the luminous flux that falls on a unit of area, whatever the material. It is the "
        "quantity irradiance of a scene in photometric units; luxel grid measures it on planes."),
     "luxel probe --quantity illuminance|luxel grid desk|luxel help grids|luxel help units"},
    {"irradiance|w/m2|w/m²|w/m^2|облучённость|облученность|вт/м²|вт/м2",
     N_("Irradiance, in W/m²: the radiant flux that falls on a unit of area, whatever the material. In photometric "
        "units it is the illuminance, in lx."),
     "luxel probe --quantity irradiance|luxel grid desk|luxel help lights[].irradiance"},
    {"candela|candelas|cd|luminous intensity|radiant intensity|w/sr|candlepower|кандела|кд|сила света|вт/ср",
     N_("Luminous intensity, in candela (cd), or radiant intensity, in W/sr: the flux that a point source sends into a "
        "unit of solid angle. It is the key intensity of a light."),
     "luxel help intensity|luxel help pattern|luxel help units"},
    {"flux|lumen|lumens|lm|luminous flux|radiant flux|w|watt|watts|power|световой "
     "поток|поток|люмен|лм|ватт|вт|мощность",
     N_("Flux, in lumen (lm) or watt (W): all that a light sends out, its key power, or all that falls on a measuring "
        "plane, which luxel grid prints."),
     "luxel help power|luxel grid desk|luxel help units"},
    {"radiance|w/(sr·m²)|w/(sr*m2)|w/(sr m2)|w/sr/m2|энергетическая яркость",
     N_("Radiance, in W/(sr·m²): the flux in a direction for each unit of area and solid angle. It is the key radiance "
        "of an extended source, and the quantity brightness where all materials have over_pi: true; in photometric "
        "units it is the luminance."),
     "luxel help lights[].radiance|luxel help over_pi|luxel help luminance"},
    {"photometric|radiometry|radiometric|lm/w|фотометрия",
     N_("Photometric units (lm, cd, lx, cd/m²) and radiometric units (W, W/sr, W/m², W/(sr·m²)): the key units chooses "
        "the names and changes no number."),
     "luxel help units"},
    {"ies|ldt|eulumdat|lm-63|luminaires|luminaire file|lamp|light fixture|polar curve|lorl|lor|dff|flux code|"
     "polar diagram|light output ratio|beam angle|"
     "светильник|светильники|лампа|ксс|кривая силы света|кпд светильника|полярная диаграмма|угол излучения",
     N_("Luminaire files, IES LM-63 and EULUMDAT: luxel photometry tells what one says and what follows from its table "
        "(flux, light output ratio, beam angles, the polar diagram). In a scene a light of the type luminaire hangs it "
        "up: its file, position, axis "
        "or "
        "aim, and c0, the direction of C = 0."),
     "luxel photometry lamp.ies|luxel help photometry|luxel help luminaire|luxel help c0"},
    {"albedo|reflectance|reflectivity|kd|коэффициент отражения",
     N_("Reflectance: the share of the light that a matt surface sends back. With over_pi: true it is the key diffuse "
        "of the material."),
     "luxel help diffuse|luxel help over_pi"},
    {"gloss|glossiness|roughness|phong exponent|ks|блеск|блик",
     N_("The highlight: its strength is the key specular of the material, its sharpness the key shininess, and "
        "highlight "
        "says what becomes of it where no light arrives."),
     "luxel help specular|luxel help shininess|luxel help highlight"},
    {"decay|inverse square|inverse square law|distance|затухание|ослабление",
     N_("How light weakens with distance: the key attenuation of a light, inverse-square unless it says otherwise."),
     "luxel help attenuation"},
    {"isolux|isoline|isolines|contour|contours|изофота|изофоты|изолюкса",
     N_("Lines of equal value: luxel isophotes gives their vertices, and luxel figure draws them."),
     "luxel help isophotes|luxel help figure"},
    {"uniformity|u0|ud|равномерность",
     N_("Uniformity of the illuminance on a plane: U0 = minimum/average and Ud = minimum/maximum, which luxel grid "
        "prints for each measuring grid."),
     "luxel help grid|luxel help grids"},
    {"ugr|glare|unified glare rating|glare rating|блёскость|блескость|ослеплённость|"
     "обобщённый показатель дискомфорта",
     N_("Glare: luxel glare gives the unified glare rating (UGR) of an observer in a scene, luminaire by luminaire; "
        "luxel "
        "photometry prints the table of ratings that catalogues quote."),
     "luxel glare office --eye 0,1200,5300,0,0,-1|luxel help glare|luxel help photometry"},
    {"daylight|daylight factor|sky|skylight|sunlight|sun hours|hours of sun|exposure to sunlight|sun patch|"
     "кео|естественное освещение|коэффициент естественной освещённости|инсоляция|солнечные часы",
     N_("Daylight comes from lights of the types sky and sun, through the openings of rooms. luxel daylight gives "
        "daylight factors, with --sun-hours the hours of sun on a day, with --sun-patches what the sun shines on."),
     "luxel help sky|luxel help sun|luxel help openings|luxel help daylight"},
    {"en12464|en 12464|en 12464-1|en12464-1|workplane|work plane|working plane|task area|measuring grid|"
     "calculation grid|рабочая плоскость|расчётная плоскость|расчётная сетка",
     N_("A work plane is an entry of the key grids: its centre, its size, and either the number of its cells or "
        "spacing: "
        "en12464, cells as EN 12464-1 asks for them. luxel grid prints its values, average, minimum, maximum and "
        "uniformity, and luxel figure --grid draws it."),
     "luxel grid office|luxel figure office --grid 1 -o plane.pdf|luxel help grids|luxel help spacing"},
    {"maintenance factor|maintenance|mf|llf|light loss factor|dimming|dimmer|dim|коэффициент запаса|"
     "коэффициент эксплуатации|диммирование",
     N_("Maintenance factor, light loss factor and dimming are shares of the light of a luminaire, its keys "
        "maintenance_factor and factor, by which its intensities are multiplied; the scene's maintenance_factor "
        "multiplies all lights. Groups of lights are dimmed by the key dimming; single ones by their intensity, power, "
        "radiance or irradiance."),
     "luxel help maintenance_factor|luxel help dimming|luxel help luminaire|luxel help intensity"},
    {"limit|verdict|verdicts|en 1838|en1838|emergency lighting|compliance|нормы|норма освещённости|"
     "аварийное освещение|проверка норм",
     N_("Limits are a key of measuring grids and of observers: average, minimum, maximum, uniformity, ratio, ugr, or "
        "preset, a row of EN 12464-1 or EN 1838. luxel grid --limits tells pass, fail or undecided and ends with 1 "
        "unless all pass."),
     "luxel help limits|luxel help preset|luxel help observers|luxel help grid"},
    {"how many luminaires|number of luminaires|lighting design|room design|dialux|relux|сколько светильников|"
     "число светильников|проект освещения",
     N_("luxel room writes the scene of a room with luminaires in an array, the least one that reaches an "
        "illuminance or the one that is named, with its work plane and limits."),
     "luxel room 8,6,2.8 --target 500|luxel help room|luxel help array|luxel help limits"},
    {"array|arrays|luminaire array|array of luminaires|ряд светильников|сетка светильников|массив светильников",
     N_("Luminaires in columns and rows are one light of the list lights with the key array, such as array: {n: [4, "
        "3], spacing: [1800, 2000]}. Many small sources at any places are one light of the type points, whose places a "
        "file lists."),
     "luxel help spacing|luxel help luminaire|luxel help lights"},
    {"plot|false color|false colour|falsecolor|colormap|graph|график|рисунок",
     N_("Pictures for people, in false colour with axes, isophotes and sections, are drawn by luxel figure."),
     "luxel help figure|luxel help report"},
    {"python|numpy|matplotlib|matlab",
     N_("A picture written as .npy is a NumPy array: numpy.load(\"sphere.npy\"). Every command prints its results as "
        "JSON "
        "with --json."),
     "luxel render -o sphere.npy|luxel probe --json"},
    {"exercise|course|lab|отчёт|отчет|вариант|лабораторная",
     N_("For the exercise of the course: luxel variant makes a numbered one, luxel explain shows how a value comes "
        "about, "
        "luxel grade judges answers, and luxel report writes the report."),
     "luxel help variant|luxel help explain|luxel help grade|luxel help report"},
};

/* ASCII and Russian letters in lower case; what is longer than the buffer is no word of the field. */
static const char *lower(const char *word, char buffer[TEXT_SIZE])
{
    size_t i = 0;

    for (; word[i] && i + 1 < TEXT_SIZE; i++) {
        const unsigned char byte = (unsigned char)word[i], before = i > 0 ? (unsigned char)word[i - 1] : 0;

        buffer[i] = (char)(byte >= 'A' && byte <= 'Z' ? byte + 'a' - 'A' : byte == '_' ? ' ' : byte);
        if (before != 0xd0) /* the first byte of Russian capitals and half of the small letters */
            continue;
        if (byte == 0x81) { /* Ё */
            buffer[i - 1] = (char)0xd1;
            buffer[i] = (char)0x91;
        } else if (byte >= 0x90 && byte <= 0x9f) {
            buffer[i] = (char)(byte + 0x20);
        } else if (byte >= 0xa0 && byte <= 0xaf) {
            buffer[i - 1] = (char)0xd1;
            buffer[i] = (char)(byte - 0x20);
        }
    }
    buffer[i] = '\0';
    return buffer;
}

static const struct entry *find(const char *word)
{
    char typed[TEXT_SIZE];
    const size_t length = strlen(lower(word, typed));

    for (size_t i = 0; i < COUNT_OF(entries) && length > 0; i++)
        for (const char *at = entries[i].words; at; at = strchr(at, '|') ? strchr(at, '|') + 1 : NULL)
            if (strcspn(at, "|") == length && strncmp(at, typed, length) == 0)
                return &entries[i];
    return NULL;
}

bool help_word_is_known(const char *word)
{
    return find(word) != NULL;
}

void help_word_print(const char *word)
{
    const struct entry *entry = find(word);

    if (!entry)
        return;
    text_definition(stdout, "", 0, _(entry->meaning));
    fputs(_("\nSee:\n"), stdout);
    for (const char *at = entry->see; *at;) {
        const size_t length = strcspn(at, "|");

        printf("  %.*s\n", (int)length, at);
        at += length + (at[length] == '|');
    }
}

void help_word_write(struct json *json, const char *word)
{
    const struct entry *entry = word ? find(word) : NULL;

    json_open(json, "words", '[');
    if (entry) {
        json_open(json, NULL, '{');
        json_text(json, "meaning", entry->meaning);
        json_open(json, "see", '[');
        for (const char *at = entry->see; *at;) {
            const size_t length = strcspn(at, "|");
            char line[TEXT_SIZE];

            snprintf(line, sizeof line, "%.*s", (int)length, at);
            json_text(json, NULL, line);
            at += length + (at[length] == '|');
        }
        json_close(json, ']');
        json_close(json, '}');
    }
    json_close(json, ']');
}
