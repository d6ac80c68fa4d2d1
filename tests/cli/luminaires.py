# SPDX-License-Identifier: MIT
"""Small luminaire files: right ones, odd ones with their warning, wrong ones with the place of the error."""

KEYS = "IESNA:LM-63-1995\n[TEST] own\n[TESTLAB] own\n[ISSUEDATE] now\n[MANUFAC] Lampe AG\n[LUMINAIRE] a\n[MORE] b\n"
HEAD = KEYS + "TILT=NONE\n"
AXIAL = "1 -1 1 3 1 1 2 .1 .2 0\n1 1 10\n0 45 90\n0\n1000 500 0\n"
LDT = ["Lampe AG", "1", "1", "1", "0", "3", "45", "report", "a", "", "a.ldt", "now", "100", "0", "50", "90", "0", "0",
       "0", "0", "0", "100", "100", "1", "0", "1", "1", "LED", "1000", "4000K", "80", "10"] + ["0"] * 10 + [
           "0", "0", "45", "90", "318.31", "225.08", "0"]


def eulumdat(**lines):
    """The file with some of its lines changed: line_29="0"."""
    changed = list(LDT)
    for name, text in lines.items():
        changed[int(name.split("_")[1]) - 1] = text
    return "\n".join(changed) + "\n"

# What is only odd: a title, the file, words of its warning.
ODD = [
    ("an odd tag", HEAD.replace("IESNA:LM-63-1995", "IESNA95") + AXIAL, "line 1, column 1: this is no version"),
    ("a tag of another year", HEAD.replace("1995", "2008") + AXIAL, "by the rules of 2002"),
    ("missing keywords", "IESNA:LM-63-2002\n[TEST] own\nTILT=NONE\n" + AXIAL, "[TESTLAB], [ISSUEDATE], [MANUFAC]"),
    ("more lumens than the lamps have", HEAD + AXIAL.replace("1 -1", "1 100"), "declared with 100 lm"),
    ("fewer", HEAD + AXIAL.replace("1 -1", "1 9000"), "declared with 9000 lm"),
    ("a plane at 360 that is missing", HEAD + AXIAL.replace("3 1 1", "3 4 1").replace(
        "0\n1000 500 0", "0 90 180 270\n" + "9 5 0 " * 4), "the plane at 360 is missing"),
    ("planes 0 and 360 that differ", HEAD + AXIAL.replace("3 1 1", "3 3 1").replace("0\n1000 500 0", "0 180 360\n" +
     "9 5 0 9 5 0 9 6 0"), "differ by up to 11.1 %"),
    ("a single plane at 45", HEAD + AXIAL.replace("\n0\n", "\n45\n"), "not 0; it is taken as axial"),
    ("90 to 270 outside 1995", HEAD.replace("1995", "2002") + AXIAL.replace("3 1 1", "3 2 1").replace(
        "\n0\n", "\n90 270\n") + "1 2 3", "in files of IESNA:LM-63-1995 alone; they are taken as there"),
    ("angles that end early", HEAD + AXIAL.replace("0 45 90", "0 45 80"), "taken as dark"),
    ("numbers too many", HEAD + AXIAL + "7 8\n", "line 14, column 1: from here on"),
    ("no lamps", HEAD + AXIAL.replace("1 -1", "0 -1"), "number of lamps is 0"),
    ("lumens of -5", HEAD + AXIAL.replace("1 -1", "1 -5"), "lumens of a lamp are -5"),
    ("an opening that LM-63 does not know", HEAD + AXIAL.replace(".1 .2 0", ".1 .2 -.3"), "taken as a box"),
    ("TILT=INCLUDE", KEYS + "TILT=INCLUDE\n1\n2\n0 90\n1 .9\n" + AXIAL, "not applied to the table"),
    ("types A and B end elsewhere", HEAD + "1 -1 1 2 2 2 2 0 0 0\n1 1 10\n-90 90\n-80 80\n1 2 3 4\n", "types A and B"),
    ("EULUMDAT: a kind", eulumdat(line_2="9"), "kind of luminaire is 9"),
    ("EULUMDAT: a ratio", eulumdat(line_23="50"), "by its light output ratio the luminaire gives 500 lm"),
    ("EULUMDAT: downwards", eulumdat(line_22="70"), "declared as 70 %, but by the table it is 100 %"),
    ("EULUMDAT: more lines", eulumdat() + "9\n", "holds more than its header"),
    ("EULUMDAT: C360", eulumdat(line_3="0", line_4="3", line_43="0\n180\n360", line_49="0\n1\n2\n3\n1\n2\n3"),
     "the last C plane is the first one again"),
]

# What is wrong: a title, the file, line and column, words of the error.
WRONG = [
    ("no luminaire", "a\nb\nc\n", "1:1", "no luminaire file"),
    ("nothing", "", "1:1", "no luminaire file"),
    ("zero bytes", HEAD + "\0" + AXIAL, "9:1", "zero bytes"),
    ("no TILT", KEYS + AXIAL, "13:1", "TILT="),
    ("TILT of nothing", KEYS + "TILT=\n" + AXIAL, "8:6", "NONE, INCLUDE"),
    ("TILT of a file that is missing", KEYS + "TILT=a.tlt\n" + AXIAL, "8:6", "cannot read a.tlt"),
    ("a word", HEAD + AXIAL.replace("500", "x"), "13:6", 'a number for a candela value, not "x"'),
    ("a comment", HEAD + AXIAL.replace("500", "500 ; half"), "13:10", "no comments"),
    ("a number that is too large", HEAD + AXIAL.replace("500", "1e999"), "13:6", "too large"),
    ("a negative intensity", HEAD + AXIAL.replace("500", "-5"), "13:6", "is -5; expected a number from 0 on"),
    ("too few", HEAD + AXIAL.replace("500", ""), "14:1", "missing: 1"),
    ("three numbers missing", HEAD + AXIAL.replace("1 1 10\n", ""), "10:1", "ballast factor, 1, input power"),
    ("type 4", HEAD + AXIAL.replace("3 1 1 2", "3 1 4 2"), "9:12", "1 (type C), 2 (type B) or 3 (type A)"),
    ("unit 3", HEAD + AXIAL.replace("1 1 2 .1", "1 1 3 .1"), "9:14", "1 (feet) or 2 (metres)"),
    ("half an angle", HEAD + AXIAL.replace("1 3 1", "1 2.5 1"), "9:8", "a whole number from 2 on"),
    ("a multiplier of 0", HEAD + AXIAL.replace("-1 1 3", "-1 0 3"), "9:6", "multiplier"),
    ("a ballast factor of 0", HEAD + AXIAL.replace("1 1 10", "0 1 10"), "10:1", "ballast factor is 0"),
    ("angles that fall", HEAD + AXIAL.replace("0 45 90", "0 90 45"), "11:6", "45 comes after 90"),
    ("angles twice", HEAD + AXIAL.replace("0 45 90", "0 45 45"), "11:6", "must rise"),
    ("angles too large", HEAD + AXIAL.replace("0 45 90", "0 45 190"), "11:6", "0 to 180"),
    ("counts beyond the file", HEAD + AXIAL.replace("3 1 1", "999999999 999999999 1"), "9:8", "in the file: 7"),
    ("planes to 120", HEAD + AXIAL.replace("3 1 1", "3 2 1").replace("\n0\n", "\n0 120\n") + "1 2 3", "12:1",
     "no symmetry that LM-63 knows"),
    ("EULUMDAT: a word", eulumdat(line_29="many"), "29:1", 'the flux of the lamps, not "many"'),
    ("EULUMDAT: no flux", eulumdat(line_29=""), "29:1", "cd/klm"),
    ("EULUMDAT: symmetry 5", eulumdat(line_3="5").replace("\n5\n", "\n4.5\n"), "1:1", "no luminaire"),
    ("EULUMDAT: conversion 0", eulumdat(line_24="0"), "24:1", "above 0"),
    ("EULUMDAT: it ends", eulumdat()[:-2], "49:1", "the file ends"),
    ("EULUMDAT: a negative intensity", eulumdat(line_48="-2"), "48:1", "an intensity is -2"),
    ("EULUMDAT: gammas", eulumdat(line_45="95"), "46:1", "must rise"),
    ("EULUMDAT: planes", eulumdat(line_3="4", line_4="4", line_43="0\n80\n180\n270"), "44:1",
     "the plane C90 must stand here, not C80"),
    ("EULUMDAT: an odd number of planes", eulumdat(line_3="2", line_4="3", line_43="0\n120\n240"), "4:1",
     "even number"),
    ("EULUMDAT: counts beyond the file", eulumdat(line_3="0", line_4="999999999"), "4:1", "in the file: 7"),
]
