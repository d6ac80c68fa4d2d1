# SPDX-License-Identifier: MIT
"""Documents as PDF: A4 pages with what was written, nothing outside the margins, fonts within, always the same bytes.

Argument: the program write_documents_pdf.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

from tap import Tap

NAMES = ("english", "russian", "hostile", "long", "empty", "large")
LEFT, RIGHT = 25 * 72 / 25.4, (210 - 25) * 72 / 25.4
WORD = re.compile(r'<word xMin="([\d.-]+)" yMin="([\d.-]+)" xMax="([\d.-]+)" yMax="([\d.-]+)">(.*)</word>')


def output_of(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True)
    return done.stdout.decode(errors="replace")


def check_form(tap, name, path):
    facts = dict(line.split(":", 1) for line in output_of("pdfinfo", path).splitlines() if ":" in line)
    tap.ok("(A4)" in facts["Page size"], name + ": A4", facts)
    tap.equal(facts["Creator"].strip(), "Luxel", name + ": its maker")
    tap.ok("CreationDate" not in facts, name + ": no date", facts)
    fonts = output_of("pdffonts", path).splitlines()[2:]
    within = all(re.search(r"\byes (yes|no) (yes|no) +\d+ +\d+$", font) for font in fonts)
    tap.ok(within, name + ": fonts within", *fonts)
    return int(facts["Pages"])


def check_margins(tap, name, path):
    """A few points are for marked rows and for the boxes of fonts, which are larger than their letters."""
    outside = []
    for match in WORD.finditer(output_of("pdftotext", "-bbox", path, "-")):
        x0, y0, x1, y1 = map(float, match.groups()[:4])
        if x0 < LEFT - 3 or x1 > RIGHT + 3 or y0 < 50 or y1 > 842 - 30:
            outside.append(match.group(0))
    tap.ok(not outside, name + ": all words within the margins", *outside[:5])


def check_words(tap, folder):
    def text_of(name, *options):
        return output_of("pdftotext", *options, os.path.join(folder, name + ".pdf"), "-")

    english, russian, hostile = text_of("english"), text_of("russian"), text_of("hostile")
    for words in ("Brightness of a ball", "A. Иванов", "Model", "The light lamp shines at a distance of 1500 mm",
                  "lights[0].falloff", "2.72759065255469", "off the surface", "The ball in false colour."):
        tap.ok(words in english, "english: " + words, english)
    for words in ("Яркость шара", "Модель расчёта", "Источник света lamp светит с расстояния 1500 мм", "наибольшее"):
        tap.ok(words in russian, "russian: " + words, russian)
    tap.ok("<script>alert(1)</script>" in hostile and "\x1b" not in hostile, "hostile: words as they are", hostile)
    pages = text_of("long", "-layout").split("\f")[:-1]
    with_table = [page for page in pages if page.count("2.72759065255469") > 3]
    tap.ok(len(with_table) > 1, "long: a table of several pages")
    tap.ok(all("примечание" in page for page in with_table), "long: each of them has the heading", *pages)
    for i, page in enumerate(pages):
        tap.ok("%d/%d" % (i + 1, len(pages)) in page.replace(" ", ""), "long: the number of page %d" % (i + 1))
        lines = [line.strip() for line in page.splitlines() if line.strip()]
        tap.ok("Результаты" not in lines[-2:], "long: no heading at the foot of page %d" % (i + 1), *lines)
    tap.equal(sum(page.count("2.72759065255469") for page in pages), 81, "long: no row is lost")
    tap.ok("drawn" in text_of("large"), "large: the drawing")


def main():
    tap = Tap()
    if not shutil.which("pdftotext"):
        tap.skip("documents as PDF", "poppler's tools are not installed")
        tap.finish()
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as again:
        tap.equal(subprocess.run([sys.argv[1], folder], check=False).returncode, 0, "the program writes")
        time.sleep(1.1)  # the second of a date would differ
        tap.equal(subprocess.run([sys.argv[1], again], check=False).returncode, 0, "the program writes again")
        for name in NAMES:
            path = os.path.join(folder, name + ".pdf")
            with open(path, "rb") as first, open(os.path.join(again, name + ".pdf"), "rb") as second:
                written = first.read()
                tap.ok(written == second.read(), name + ": the same bytes")
            pages = check_form(tap, name, path)
            tap.ok(pages > 5 if name in ("long", "large") else pages in (1, 2), name + ": pages", pages)
            tap.ok((b"/Outlines" in written) == (name != "empty"), name + ": an outline")
            check_margins(tap, name, path)
        check_words(tap, folder)
    tap.finish()


main()
