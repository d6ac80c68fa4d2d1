# SPDX-License-Identifier: MIT
"""Writes the first inputs of the fuzz targets into fuzz/corpus/: what users have, and the wrong scenes of the tests.

    python3 fuzz/make_corpus.py BUILD      # BUILD/cli/luxel makes pictures and numbers
"""
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tests/cli"))
sys.path.insert(0, str(HERE.parent / "tests"))
sys.path.insert(0, str(HERE.parent / "tests/unit"))


def put(target, name, data):
    folder = HERE / "corpus" / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(data if isinstance(data, bytes) else data.encode())


def scenes(luxel):
    listed = subprocess.run([luxel, "scene", "--list"], check=True, capture_output=True, text=True).stdout
    for name in [line.split()[0] for line in listed.split("\n") if line.strip()]:
        text = subprocess.run([luxel, "scene", name], check=True, capture_output=True).stdout
        put("scene", name + ".yaml", text)


def malformed():
    import malformed as pieces
    from tool import SCENE
    for i, (_, piece, replacement, _) in enumerate(pieces.PIECES):
        put("scene", "wrong-%03d.yaml" % i, SCENE.replace(piece, replacement.replace("^", ""), 1))


def pictures(luxel, folder):
    small = ["-s", "screen.resolution=[12, 12]"]
    for ending in ["png", "exr", "npy", "pfm", "csv"]:
        path = folder / ("a." + ending)
        subprocess.run([luxel, "render", "report", *small, "-o", path, "-q"], check=True, capture_output=True)
        data = path.read_bytes()
        if ending in ("png", "exr"):
            put("scene", "carried." + ending, data)
        if ending != "png":
            put("field", "a." + ending, bytes([["npy", "pfm", "csv", "exr"].index(ending)]) + data)
    subprocess.run([luxel, "render", "report", *small, "-o", folder / "d.npy", "--precision", "double", "-q"],
                   check=True, capture_output=True)
    put("field", "double.npy", b"\0" + (folder / "d.npy").read_bytes())
    for i, text in enumerate(FIELDS):
        put("field", "table-%02d.csv" % i, b"\2" + text.encode())


FIELDS = [
    "x_mm;y_mm;value_lx\r\n0;0;1,5\r\n10;0;inf\r\n", "sep=;\nx (m);y (cm);value;\n0;0;1;\n0,01;0;nan;\n",
    "x y value # none\r0 0 1\r10 0 2.5", ",value (lx),y,x,note\n0,1,0,0,a\n1,2,0,5,\"b\n c\"\n", "0\t0\t1,5\n1\t0\t2\n",
]

EDITS = [
    "report\nlights[0].intensity=20\nlights[0].name=lamp\n-lights[0].name\n"
    "+lights 1 {type: ambient, irradiance: 1}\n",
    "three-lights\n>lights 0 2\n-lights[1]\nsurfaces[0].material.shininess=1e3\n-lights[0]\n-lights[0]\n",
    "window\nlights[0].parts=4\nlights[0].parts=converged\n+points 0 [1, 2]\n>points 0 0\n-points[0]\n",
    "desk\n-grids\n+grids 0 {name: a, center: [0, 0, 0], size: [10, 10], n: [2, 2]}\npicture.range=[1, 2]\n",
    "all-sources\n-lights[8]\n-lights[7]\n-lights[6]\nscreen={width: 100, height: 100, resolution: [5, 5]}\n",
    "spot\nlights=[]\n+lights 0 {type: spot, position: [0, 0, 2000], inner: 1, outer: 2, intensity: 3}\n"
    "units=radiometric\n",
    "nothing\nlights[0]=5\nlights.0.x=1\nlights[99999999999999999999]=1\n=\nx\n+lights x\n>lights 1\n",
]


def luminaires():
    import photometry_model
    rng = random.Random(63)
    for i in range(14):
        make = photometry_model.random_ldt if i % 2 else photometry_model.random_ies
        data = next(data for data, _ in iter(lambda: make(rng), None) if len(data) < 3000)
        put("photometry", "random-%02d.%s" % (i, "ldt" if i % 2 else "ies"), data)
    for name, text in LUMINAIRES.items():
        put("photometry", name, text)


HEAD = "IESNA:LM-63-1995\n[MANUFAC] own\n[MORE] more\nTILT=NONE\n"
LUMINAIRES = {
    "commas.ies": HEAD + "1 1000 1 3 1 1 2 0,1 0,2 0\n1 1 10\n0 45 90\n0\n100,5 50,25 0\n",
    "feet.ies": HEAD + "1,-1,1,3,2,1,1,-.5,0,-.5 1 1 10 0 45 90 0 90 1 2 3 4 5 6 7\n",
    "open-turn.ies": HEAD + "1 1000 1 2 4 1 2 -1 -1 0 1 1 10 0 90 0 90 180 270 1 2 3 4 5 6 7 8",
    "turn.ies": HEAD + "1 1000 1 2 3 1 2 -1 -1 0 1 1 10 0 90 -180 0 180 1 2 3 4 1 9",
    "tilt.ies": HEAD.replace("NONE", "INCLUDE") + "1\n2\n0 90\n1 .9\n1 1000 1 2 1 1 2 0 0 0 1 1 10 0 180 0 1 2",
    "tilt-huge.ies": HEAD.replace("NONE", "INCLUDE") + (
        "13333333333333333333\n1\n0\n1\n1 1000 1 2 1 1 2 0 0 0 1 1 10 0 90 0 1 2"),
    "tilt-file.ies": HEAD.replace("NONE", "none.tlt") + "1 1000 1 2 1 1 2 0 0 0 1 1 10 0 180 0 1 2",
    "three.ies": HEAD + "1 1000 1 3 1 1 2 0 0 0\n0 45 90\n0\n1 2 3 ; comment\n",
    "huge.ies": HEAD + "1 1000 1 999999999 999999999 1 2 0 0 0 1 1 10 0 45 90\n",
    "wrong.ies": "IESNA\nTILT=\n-1 -2 0 1.5 0 4 3 x 1e999 0 0 0 -1\n",
    "sideways.ies": HEAD + "1 -1 1 3 3 2 2 0 0 0 1 1 10 -90 0 90 -90 0 90 0 0 0 0 9 0 0 0 0",
    "upright.ies": HEAD + "1 -1 1 3 2 3 2 0 0 0 1 1 10 -90 0 90 0 90 0 9 0 0 0 0",
    "huge.ldt": "own\n1\n0\n999999999\n0\n999999999\n0\n" + "\n" * 18 + "1\n1\nLED\n1000\n\n\n10\n" + "0\n" * 12,
    "blank.ldt": "\n" * 60,
    "wrong.ldt": "own\n7\n5\n1.5\nx\n1\n0\n" + "a\n" * 19 + "0\n",
    "no-zero.ldt": "own\n1\n3\n4\n0\n2\n0\n\n\n\n\n\n9\n9\n9\n9\n0\n1\n1\n1\n1\n90\n80\n1\n0\n2\n" + (
        "1\nLED\n1000\n\n\n10\n" * 2) + "0\n" * 10 + "0\n90\n180\n270\n0\n90\n1\n2\n3\n4\n5\n6\nmore\n",
}


def meshes():
    import good_scenes
    put("mesh", "cube.off", b"\0" + good_scenes.FILES["cube.off"].encode())
    put("mesh", "cube.obj", b"\1" + good_scenes.FILES["cube.obj"].encode())
    put("mesh", "open.off", "\0OFF\n4 3 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n3 0 2 1\n3 0 1 3\n3 1 2 3\n")
    put("mesh", "comments.obj", "\1# a body\nv 0 0 1500\nv 90 0 1500 # corner\nv 0 90 1500\nv 0 0 1590\n"
        "f 1/1 3/2 2//3\nf -4 -3 -1\nf 2 3 4\nf 3 1 4\n")
    cube_off, cube_obj = good_scenes.FILES["cube.off"], good_scenes.FILES["cube.obj"]
    put("mesh", "joined.off", b"\0\xef\xbb\xbf" + cube_off.replace("OFF\n", "off").encode())
    put("mesh", "one-line.off", "\0" + cube_off.replace("\n", " "))
    put("mesh", "old-mac.obj", "\1" + cube_obj.replace("\n", "\r"))
    put("mesh", "utf-16.obj", b"\1" + cube_obj.encode("utf-16"))
    put("mesh", "left-out.obj", "\1" + cube_obj + "f 1 2\nf 3\np 1\nl 1 2\n" + cube_obj.split("\n")[-2] + " \\ \n\n")
    put("mesh", "free-form.obj", "\1v 0 0 0\ncstype bezier\n")
    put("mesh", "binary.off", b"\0OFF BINARY\n\0\0\0\1")
    put("mesh", "four.off", "\0" + "4OFF\n1 1 1\n")
    put("mesh", "normals.off", "\0CNOFF 4 4 6 " + "".join("%s %s %s 0 0 1 9 9 9 1 " % place for place in (
        (0, 0, 1500), (90, 0, 1500), (0, 90, 1500), (0, 0, 1590))) + "3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2")
    put("mesh", "rounded.off", "\0OFF\n6 5 0\n0.1 0 1500\n90.2 30.7 1500.1\n59.6 120.9 1500.2\n-30.5 90.3 1500.1\n"
        "0 0 1590.4\n0.1 0.1 1590.4\n4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 5\n3 3 0 5\n")
    put("mesh", "huge.off", "\0OFF\n999999999 999999999 0\n1 2 3\n")


# As a spreadsheet, a teacher and a student in a hurry write them.
ANSWERS = [
    "variant,point,value\n1,1,3.14\n1,P2,0.5e-1\n2,p5,off\n",
    "variant,x_mm,y_mm,value\n17,0,0,12.5\n17,-150.25,1e2,-\n1000000,0.5,-0.5,.25\n",
    "\ufeffвариант;точка;значение;студент\r\n3;1;3,1416;Ann\r\n3;2;0,25;\"Боб; второй\"\r\n",
    "name\tVariant\tPoint\tValue\nx\t9\t1\t 7 \n\ty\t\t\n",
    '"variant","x","y","value","student"\n1,"0","0","3,25","a ""b"" c"\n1,1,1,none,"two\nlines"\n',
    "variant,point,x,y,value\n4,,10,20,3\n4,3,,,255\n4,1,1,1,NaN\n\n \n4,2,0,0,0.5\n",
    "variant,point,value\r1,1,2\r0,1,2\r1000001,1,2\r1,0,2\r1,1001,2\r1,1,\r1,1,x\r1,1,1e999\r1,1,0e9999\r",
    "variant,point,value\n1,1,2,5\n1,1\n01,+1,2\n1,1,\u22122\n\u0416,1,2\n1,1,1e\n1,1,--1\n",
    "variant,point,value\n1,1,2.5\n", "variant,x,y,value\n1,0,0,12.732395\n", "variant,x,y,value\n1,100,0,127\n",
    "variant,x,y,value\n1,500,0,off\n", "variant,x,y,value\n1,-150,100,1.0\n",
    "point,value\n1,2\n", "variant,point,value,value\n", "variant,point,value\n1,1,\"2\n",
    "variant,point,value\n1,1,\"2\"3\n", "", "\n\n", "a" * 300, '"' * 99, "variant,point,value\n\0",
    'student,variant,point,value\n"\x1b[31m\nred",1,1,x\n\u009b2J,1,1,9\n',
    "sep=;\r\nВариант;Точка;Значение, Вт/ср;\r\n3;1;3,1416;\r\n;;;\r\n",
    "# lamps\n,variant,x (cm),y [m],value\n0,1,1,0.1,2\n",
    "variant\tpoint\tvalue\n\"1\"\t1\t1,234\n2\t1\t1.5\n",
]

ARGUMENTS = [
    "render report -s lights[0].intensity=20 --quantity irradiance --precision double",
    "probe three-lights -p 0,0 -p -150,1e2 --at 0,0,1300,0,0,1 --tolerance 1e-6",
    "probe report --at 1,2,3,0,0,1 --view 1,0,2 --material 0", "probe report --points places.csv --view 0,0,0",
    "probe report --at 1,2,3,0,0,0", "probe report -p 1;2", "probe report --at=1,2", "probe report -p 1,2 --json -q",
    "set report screen.sampling=nodes surfaces[0].material.shininess=60 --dry-run",
    "set report lights=[] lights.0.type=point", "check window --strict -s lights[0].parts=4",
    "stats report --region 0,0,100,50 --histogram --bins 32 --scale 0,1 --log",
    "stats report --region 1,2,0", "stats --bins 0", "profile report --from -100,0 --to 100,0 --samples 50 --arc",
    "profile --through 1,2 --angle 45 --csv=excel-ru", "isophotes report --levels 10",
    "isophotes report --levels 0.5,1e0,2 -o a.csv", "isophotes report --levels 5,", "isophotes --levels 1,,2",
    "figure report --palette turbo --width 120 --dpi 300 --section --title x", "figure --section=maximum",
    "grade a.csv --format html", "variant 7 -s screen.width=900", "help lights.intensity", "schema extra",
    "render --threads 1025", "render --threads=4 --bits 16 -o a.png -o -", "render --out a.png", "render --s x",
    "rendr", "report report --author A --group 1 --date today", "--version", "--help", "-s a=b", "-x", "--",
    "-- render",
    "render -s", "render --quantity brightnes", "render --quiet=1", "stats -q --light-error 0.1", "render report more",
]


def other_meshes():
    """A box, a roof with normals and a strip in each of the other formats, and what readers trip over."""
    import mesh_files
    corners, faces = mesh_files.box((120, 90, 60))
    roof, slopes = [(-9, 0, 0), (0, 0, 9), (9, 0, 0), (-9, 9, 0), (0, 9, 9), (9, 9, 0)], [(0, 1, 4, 3), (1, 2, 5, 4)]
    leaning = [(-1, 0, 1), (0, 0, 1), (1, 0, 1)] * 2
    little, big = "binary_little_endian", "binary_big_endian"
    kinds = {"ply": 2, "stl": 3, "gltf": 4, "glb": 5}

    def add(name, data):
        put("mesh", name, bytes([kinds[name.rsplit(".", 1)[1]]]) + data)
    add("box.ply", mesh_files.ply(corners, faces))
    add("more.ply", mesh_files.ply(roof, slopes, normals=leaning, extra=True))
    add("little.ply", mesh_files.ply(corners, faces, little, extra=True, index="uint", name="vertex_index"))
    add("big.ply", mesh_files.ply(roof, slopes, big, leaning, count="ushort", place="float"))
    add("no-end.ply", mesh_files.ply(corners, faces, little)[:-3])
    add("many.ply", b"ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n1\n")
    add("text.stl", mesh_files.stl_text(corners, faces, solids=2))
    add("binary.stl", mesh_files.stl_binary(corners, faces))
    add("short.stl", mesh_files.stl_binary(corners, faces)[:-9])
    corners = [[c / 1000 for c in corner] for corner in corners]  # metres
    roof = [[c / 1000 for c in corner] for corner in roof]
    document, data = mesh_files.gltf_parts(corners, faces)
    add("box.gltf", mesh_files.gltf(document, data))
    add("box.glb", mesh_files.glb(document, data))
    add("away.gltf", mesh_files.gltf(document, data, "box.bin"))
    add("cut.glb", mesh_files.glb(document, data)[:-40])
    document["extensionsRequired"] = ["KHR_draco_mesh_compression"]
    add("draco.gltf", mesh_files.gltf(document, data))
    document, data = mesh_files.gltf_parts(roof, slopes, leaning, indexed=False, stride=8,
                                           node={"scale": [-1, 2, 1], "rotation": [0, 0.6, 0, 0.8]})
    add("turned.glb", mesh_files.glb(document, data))
    document, data = mesh_files.gltf_parts(roof, slopes, mode=5, indices=[0, 1, 3, 4, 65535, 1, 2, 4, 5])
    document["accessors"][0]["sparse"] = {"count": 1, "indices": {"bufferView": 1, "componentType": 5123},
                                          "values": {"bufferView": 0}}
    add("strip.glb", mesh_files.glb(document, data))
    document["nodes"][0]["children"] = [0]
    add("circle.glb", mesh_files.glb(document, data))


def answers():
    for i, text in enumerate(ANSWERS):
        put("answers", "table-%02d.csv" % i, text)


def arguments():
    for i, line in enumerate(ARGUMENTS):
        put("arguments", "line-%02d" % i, line.replace(" ", "\0"))
    put("arguments", "lines-of-yaml", "check\0report\0-s\0lights=\n- type: ambient\n  irradiance: 1 # dim\n\0")
    put("arguments", "steering", "check\0-s\0\x1b[31m=\u009b\0--tolerance\0\x07\0")


CLOUDS = [
    "2000,0,2000,10\n-300.5,200,1800,2.5\n0,0,1500,0.125\n",
    "\ufeffX\tY\tZ\tIntensity\r\n2000\t0\t2000\t10\r\n", "x;y;z;intensity\n1;2;1500;3 # bright\n",
    "# lamps\n\n  10 20 1500 1\n-1e3 .5 +2e3 0\n", "1,2,3\n", "1,2,3,4,5\n", "1,5;2;3;4\n", "1,2,3,nan\n",
    "1,2,-1e999,1\n",
    "1,2,3,-4\n", "x,y,z,intensity\n1,2,3,much\n", "x,y,z,intensity\n", "", "1,2,3,4", "1,2,3,%s\n" % ("\u20ac" * 30),
    "1e6,1e6,1e6,1e12\n0,0,1000,1\n", "1 2,3 4\n", "1,2,,4\n",
    "sep=;\r\n2000;0,5;2000;10;\r\n;;;;\r\n", "I (mW/sr),z [m],y_cm,\"x, mm\"\n9000,1.5,2,\"3,5\"\n",
    ",x,y,z,intensity\n0,1,2,1500,3\n", '"x" "y" "z" "intensity"\n"1" 1 2 1500 3\n',
    "# x y z I\n1\t0,5\t1500\t3\r2\t0,5\t1500\t3",
    "2\na.jpg 1 2 1500\n\"b c.jpg\" 3 4 1500,5\n", "3\na 1 2 1500\n", "x;y;z;I\n1.5;2;1,500;4\n", "sep=|\n1|2|3|4\n",
    "x (furlong),y,z,I\n1,2,3,4\n", "x,x,y,z,I\n1,1,2,3,4\n",
]


# What --points takes, and what it does not.
PLACES = [
    "x,y\n0,0\n150,-20.5\n", "0 0 1300 0 0 1\n10 0 1200 0.5 0 0.866\n",
    "x_mm;y_mm;z_mm;nx;ny;nz\n0;0;;;;\n0;0;1300;0;0;1\n", "# x y Group\n1 2 3\n", "x,y,z\n1,2,3\n", "1,2,3,0,0,0\n",
    "x (m),y (cm),note\n0.1,2,\"a, b\"\n", "1,5;2,5\n",
]


def npy(rows, descr, more=""):
    columns = len(rows[0]) if rows else 4
    shape = (len(rows), columns)
    text = "{'descr': '%s', 'fortran_order': %s, 'shape': %s, }" % (descr, more or "False", shape)
    kind = (">" if descr[0] == ">" else "<") + columns * ("f" if descr.endswith("4") else "d")
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text.encode()
            + b"".join(struct.pack(kind, *row) for row in rows))


def clouds():
    rows = [(2000, 0, 2000, 10), (-300.5, 200, 1800, 2.5), (0, 0, 1500, 0.125), (1, 1, 1600, 0)]
    for i, text in enumerate(CLOUDS):
        put("points", "cloud-%02d.csv" % i, text)
    put("points", "utf-16.csv", CLOUDS[0].encode("utf-16"))
    put("points", "utf-16-be.csv", "x;y;z;I\n1;2,5;1500;3\n".encode("utf-16-be"))
    put("points", "cp1251.csv", "х;у;z;Сила света\n1;2,5;1500;3\n".encode("cp1251"))
    for descr in ("<f8", ">f8", "<f4", ">f4", "<i8"):
        put("points", "cloud-%s.npy" % descr.replace("<", "little-").replace(">", "big-"), npy(rows, descr))
    for i, text in enumerate(PLACES):
        put("points", "places-%02d.csv" % i, text)
    put("points", "three-columns.npy", npy([row[:3] for row in rows], "<f8"))
    put("points", "three-columns-first.npy", npy([row[:3] for row in rows], ">f4", "True"))
    put("points", "two-columns.npy", npy([row[:2] for row in rows], "<f8"))
    put("points", "six-columns.npy", npy([(0, 0, 1300, 0, 0, 1), (0, 0, 1300, 0, 0, 0)], "<f4"))
    put("points", "six-columns-first.npy", npy([(0, 0, 1300, 0, 0, 1), (5, 5, float("nan"), 0, 1, 0)], "<f8", "True"))
    put("points", "columns-first.npy", npy(rows, "<f8", "True"))
    put("points", "cut-off.npy", npy(rows, "<f8")[:-1])
    put("points", "no-rows.npy", npy([], "<f8"))
    put("points", "not-finite.npy", npy([(1, 2, float("inf"), 4)], "<f4"))
    put("points", "below-0.npy", npy([(1, 2, 3, -4)], "<f4"))


def main():
    luxel = sys.argv[1] + "/cli/luxel"
    rng = random.Random(1)
    scenes(luxel)
    malformed()
    with tempfile.TemporaryDirectory() as folder:
        pictures(luxel, pathlib.Path(folder))
    for i, text in enumerate(EDITS):
        put("edit", "edits-%d.txt" % i, text)
    meshes()
    other_meshes()
    luminaires()
    answers()
    arguments()
    clouds()
    for i in range(24):
        put("numbers", "random-%02d" % i, rng.randbytes(96))
    for i in range(12):  # enough for scenes of several surfaces and lights
        put("numbers", "long-%02d" % i, rng.randbytes(320))


main()
