/* SPDX-License-Identifier: MIT */
/*
 * What advice says, word for word: in scenes on either side of each limit, the message with its number and the change
 * that is suggested.  LUXEL_ADVICE=print tells the texts that are found.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/exercise.h>

#include "scenes.h"

enum { ROOM = 4000 };

struct asked {
    const char *scene, *changes[2];
    const char *said; /* of each entry: key, message, hint */
};

static const struct asked asked[] = {
    {"report",
     {"surfaces[0].material.specular=0.5"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"surfaces[0].material.specular=0.1"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 2.4 %: the peak hardly stands out; try "
     "-s 'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.specular=0.06"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 1.2 %: the peak hardly stands out; try "
     "-s 'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.specular=0.05"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 1 %: the peak hardly stands out; try -s "
     "'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.specular=0.04"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 0.8 %: the peak hardly stands out; try "
     "-s 'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.specular=0.03"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 0.6 %: the peak hardly stands out; try "
     "-s 'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.specular=0.01"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 0.2 %: the peak hardly stands out; try "
     "-s 'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.specular=0"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 0 %: the peak hardly stands out; try -s "
     "'surfaces[0].material.specular=0.2'\n"},
    {"report",
     {"surfaces[0].material.shininess=1"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.shininess: the highlight falls to half only 60° away from its middle: it is too wide to be "
     "seen as a peak; try -s 'surfaces[0].material.shininess=20'\n"},
    {"report",
     {"surfaces[0].material.shininess=2"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.shininess: the highlight falls to half only 45° away from its middle: it is too wide to be "
     "seen as a peak; try -s 'surfaces[0].material.shininess=20'\n"},
    {"report",
     {"surfaces[0].material.shininess=3"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.shininess: the highlight falls to half only 37° away from its middle: it is too wide to be "
     "seen as a peak; try -s 'surfaces[0].material.shininess=20'\n"},
    {"report",
     {"surfaces[0].material.shininess=5"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"surfaces[0].material.shininess=8"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"surfaces[0].material.shininess=500"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"surfaces[0].material.shininess=3000"},
     "surfaces[0].material.shininess: shininess = 3000 lies outside the advised range 1 to 500; try -s "
     "'surfaces[0].material.shininess=500'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"surfaces[0].material.shininess=20000"},
     "surfaces[0].material.shininess: shininess = 20000 lies outside the advised range 1 to 500; try -s "
     "'surfaces[0].material.shininess=500'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"surfaces[0].material.shininess=200000"},
     "surfaces[0].material.shininess: shininess = 200000 lies outside the advised range 1 to 500; try -s "
     "'surfaces[0].material.shininess=20'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.shininess: the highlight falls to half within 0.57 of a pixel: the picture may miss its "
     "peak; try -s 'surfaces[0].material.shininess=20'\n"},
    {"report",
     {"surfaces[0].material.model=phong", "surfaces[0].material.shininess=0.5"},
     "surfaces[0].material.shininess: shininess = 0.5 lies outside the advised range 1 to 500; try -s "
     "'surfaces[0].material.shininess=20'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.shininess: the highlight falls to half only 38° away from its middle: it is too wide to be "
     "seen as a peak; try -s 'surfaces[0].material.shininess=20'\n"},
    {"report",
     {"surfaces[0].material.model=phong", "surfaces[0].material.shininess=20000"},
     "surfaces[0].material.shininess: shininess = 20000 lies outside the advised range 1 to 500; try -s "
     "'surfaces[0].material.shininess=20'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "surfaces[0].material.shininess: the highlight falls to half within 0.9 of a pixel: the picture may miss its "
     "peak; try -s 'surfaces[0].material.shininess=20'\n"},
    {"report",
     {"lights=[]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s 'lights=[{type: point, "
     "position: [600, 600, 2500], intensity: 10}]'\n"},
    {"report",
     {"lights[0].enabled=false"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s 'lights[0].enabled=true'\n"},
    {"report",
     {"lights[0].intensity=0"},
     "lights[0].intensity: intensity = 0 lies outside the advised range 0.01 to 10000 W/sr; try -s "
     "'lights[0].intensity=10'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s 'lights[0].intensity=10'\n"},
    {"distant",
     {"lights[0].irradiance=0", "lights[1].irradiance=0"},
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s 'lights[0].irradiance=10'\n"},
    {"window",
     {"lights[0].radiance=0", "lights[1].irradiance=0"},
     "lights[0].radiance: radiance = 0 lies outside the advised range 0.01 to 1000000 W/(sr·m²); try -s "
     "'lights[0].radiance=100'\n"
     "surfaces[0].material.specular: with specular the material reflects 110 % of the light, seen straight on: more "
     "than falls in; try -s 'surfaces[0].material.specular=0.4'\n"
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s 'lights[0].radiance=100'\n"},
    {"report",
     {"surfaces[0].material.diffuse=0", "surfaces[0].material.specular=0"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s "
     "'surfaces[0].material.diffuse=0.8'\n"},
    {"report",
     {"lights[0].position=[0,0,1000]", "surfaces[0].material.highlight=gated"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light stands inside or behind every surface: it lights nothing in view; try -s "
     "'lights[0].position=[600, 300, 2200]'\n"
     "lights: no light reaches what is seen of the surfaces: the picture is dark; try -s 'lights[0].position=[600, "
     "300, 2200]'\n"},
    {"report",
     {"lights[0].position=[500,-300,200]", "surfaces[0].material.highlight=gated"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=550' -s 'screen.height=550'\n"},
    {"report",
     {"screen={width: 300, height: 300, resolution: [300, 300]}"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=360' -s 'screen.height=360'\n"},
    {"report",
     {"screen={width: 303, height: 307, resolution: [303, 307]}"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=606' -s 'screen.height=614'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=363.6' -s 'screen.height=368.4'\n"},
    {"report",
     {"screen={width: 340, height: 340, resolution: [340, 340]}"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=680' -s 'screen.height=680'\n"
     "screen: the brightest place lies on the edge of the screen, so the peak is not wholly in view; try -s "
     "'screen.width=374' -s 'screen.height=374'\n"},
    {"report",
     {"screen={width: 360, height: 360, resolution: [360, 360]}"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=720' -s 'screen.height=720'\n"},
    {"report",
     {"screen={width: 400, height: 400, resolution: [400, 400]}"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"distant",
     {"lights=[{type: distant, direction: [-1, 0, 1], irradiance: 10}]"},
     "surfaces[0]: the brightest place lies on the rim of what is seen of surfaces[0], so the peak is not wholly in "
     "view; try -s 'lights[0].direction=[-2, -1, -3]'\n"},
    {"distant", {"lights=[{type: distant, direction: [-1, 0.4, -0.2], irradiance: 10}]"}, ""},
    {"distant",
     {"lights=[{type: point, position: [2000, 0, 200], intensity: 10}]"},
     "surfaces[0]: the brightest place lies on the rim of what is seen of surfaces[0], so the peak is not wholly in "
     "view; try -s 'lights[0].position=[720, 360, 2500]'\n"},
    {"distant",
     {"lights=[{type: point, position: [2000, 0, 700], intensity: 10}]"},
     "surfaces[0]: the brightest place lies on the rim of what is seen of surfaces[0], so the peak is not wholly in "
     "view; try -s 'lights[0].position=[720, 360, 2500]'\n"},
    {"distant", {"lights=[{type: point, position: [2000, 0, 1000], intensity: 10}]"}, ""},
    {"distant", {"lights=[{type: point, position: [2000, 0, 1200], intensity: 10}]"}, ""},
    {"report",
     {"picture.range=[0,5]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: 27 % of what is seen of the surfaces is brighter than this range, and just white in the picture; "
     "try -s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[0,11]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: 1.3 % of what is seen of the surfaces is brighter than this range, and just white in the picture; "
     "try -s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[0,12]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"picture.range=[0,100]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: the brightest place has the grey level 29 of 255 in this range: the picture is nearly black; try "
     "-s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[0,160]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: the brightest place has the grey level 18 of 255 in this range: the picture is nearly black; try "
     "-s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[0,170]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: the brightest place has the grey level 17 of 255 in this range: the picture is nearly black; try "
     "-s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[0,1000]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: the brightest place has the grey level 2 of 255 in this range: the picture is nearly black; try "
     "-s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[100,1000]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: the brightest place has the grey level 0 of 255 in this range: the picture is nearly black; try "
     "-s 'picture.range=max'\n"},
    {"report",
     {"picture.range=[5,11]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "picture.range: 1.3 % of what is seen of the surfaces is brighter than this range, and just white in the picture; "
     "try -s 'picture.range=max'\n"},
    {"report",
     {"lights[0].position=[0,0,1301]", "lights[0].attenuation=inverse-square"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light stands only 1 mm away from a surface: it brightens little more than the place "
     "below it; try -s 'lights[0].position=[0, 0, 1600]'\n"},
    {"report",
     {"lights[0].position=[0,0,1305]", "lights[0].attenuation=inverse-square"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light stands only 5 mm away from a surface: it brightens little more than the place "
     "below it; try -s 'lights[0].position=[0, 0, 1610]'\n"},
    {"report",
     {"lights[0].position=[0,0,1315]", "lights[0].attenuation=inverse-square"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].position=[0,0,1330]", "lights[0].attenuation=inverse-square"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].position=[0,0,1400]", "lights[0].attenuation=inverse-square"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].position=[2e4,0,2e4]", "lights[0].attenuation=inverse-square"},
     "lights[0].position[0]: position[0] = 20000 lies outside the advised range -10000 to 10000 mm; try -s "
     "'lights[0].position[0]=10000'\n"
     "lights[0].position[2]: position[2] = 20000 lies outside the advised range 100 to 10000 mm; try -s "
     "'lights[0].position[2]=10000'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].position=[6e4,0,6e4]", "lights[0].attenuation=inverse-square"},
     "lights[0].position[0]: position[0] = 60000 lies outside the advised range -10000 to 10000 mm; try -s "
     "'lights[0].position[0]=10000'\n"
     "lights[0].position[2]: position[2] = 60000 lies outside the advised range 100 to 10000 mm; try -s "
     "'lights[0].position[2]=10000'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].position=[1e5,0,1e5]", "lights[0].attenuation=inverse-square"},
     "lights[0].position[0]: position[0] = 100000 lies outside the advised range -10000 to 10000 mm; try -s "
     "'lights[0].position=[4300, 0, 5200]'\n"
     "lights[0].position[2]: position[2] = 100000 lies outside the advised range 100 to 10000 mm; try -s "
     "'lights[0].position=[4300, 0, 5200]'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light is so far away that its attenuation changes by only 0.86 % over the surfaces; try "
     "-s 'lights[0].position=[4300, 0, 5200]'\n"},
    {"report",
     {"lights[0].position=[2e5,0,2e5]", "lights[0].attenuation=inverse-square"},
     "lights[0].position[0]: position[0] = 200000 lies outside the advised range -10000 to 10000 mm; try -s "
     "'lights[0].position=[4300, 0, 5200]'\n"
     "lights[0].position[2]: position[2] = 200000 lies outside the advised range 100 to 10000 mm; try -s "
     "'lights[0].position=[4300, 0, 5200]'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light is so far away that its attenuation changes by only 0.43 % over the surfaces; try "
     "-s 'lights[0].position=[4300, 0, 5200]'\n"},
    {"report",
     {"lights[0].attenuation=practical", "lights[0].k=100"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].attenuation=practical", "lights[0].k=2e4"},
     "lights[0].k: k = 20000 lies outside the advised range 10 to 2000 mm; try -s 'lights[0].k=2000'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"},
    {"report",
     {"lights[0].attenuation=practical", "lights[0].k=1e5"},
     "lights[0].k: k = 100000 lies outside the advised range 10 to 2000 mm; try -s 'lights[0].k=2000'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light is so far away that its attenuation changes by only 0.59 % over the surfaces; try "
     "-s 'lights[0].position=[1300, 0, 1700]' -s 'lights[0].k=100'\n"},
    {"report",
     {"lights[0].attenuation=practical", "lights[0].k=2e6"},
     "lights[0].k: k = 2000000 lies outside the advised range 10 to 2000 mm; try -s 'lights[0].k=2000'\n"
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: left, right, "
     "bottom, top; try -s 'screen.width=600' -s 'screen.height=600'\n"
     "lights[0].position: the light is so far away that its attenuation changes by only 0.03 % over the surfaces; try "
     "-s 'lights[0].position=[1300, 0, 1700]' -s 'lights[0].k=100'\n"},
    {"desk",
     {"lights[0].position=[0, -150, 901]"},
     "lights[0].position: the light stands only 0.6 mm away from a surface: it brightens little more than the place "
     "below it; try -s 'lights[0].position=[0, 360, 1290]'\n"},
    {"desk",
     {"lights[0].position=[0, -150, 905]"},
     "lights[0].position: the light stands only 3 mm away from a surface: it brightens little more than the place "
     "below it; try -s 'lights[0].position=[0, 360, 1290]'\n"},
    {"desk",
     {"lights[0].position=[500, -150, 930]"},
     "lights[0].position: the light stands only 18 mm away from a surface: it brightens little more than the place "
     "below it; try -s 'lights[0].position=[500, 360, 1310]'\n"},
    {"desk",
     {"lights[0].position=[620, 60, 900]"},
     "surfaces[1]: the brightest place lies on the rim of what is seen of surfaces[1], so the peak is not wholly in "
     "view; try -s 'lights[0].position=[1000, 390, 2800]'\n"
     "surfaces[1].material.specular: the highlight raises the maximum by only 0.1 %: the peak hardly stands out; try "
     "-s 'surfaces[1].material.specular=0.2'\n"},
    {"desk",
     {"lights[0].position=[-3e5, 2e5, 2e5]", "lights[0].intensity=1e8"},
     "lights[0].position[0]: position[0] = -300000 lies outside the advised range -10000 to 10000 mm; try -s "
     "'lights[0].position=[0, 10000, 9000]'\n"
     "lights[0].position[1]: position[1] = 200000 lies outside the advised range -10000 to 10000 mm; try -s "
     "'lights[0].position=[0, 10000, 9000]'\n"
     "lights[0].position[2]: position[2] = 200000 lies outside the advised range 100 to 10000 mm; try -s "
     "'lights[0].position=[0, 10000, 9000]'\n"
     "lights[0].intensity: intensity = 100000000 lies outside the advised range 0.01 to 10000 cd; try -s "
     "'lights[0].intensity=10000'\n"
     "lights[0].position: the light is so far away that its attenuation changes by only 0.62 % over the surfaces; try "
     "-s 'lights[0].position=[0, 10000, 9000]'\n"},
    {"spot",
     {"surfaces[0].center=[900, 0, 600]"},
     "surfaces[0]: surfaces[0] is not wholly in view: it reaches beyond the screen on these sides: right; try -s "
     "'screen.width=3200' -s 'screen.height=3200'\n"},
    {"two-spheres",
     {"surfaces[1].center=[2000, 0, 1330]"},
     "surfaces[1]: surfaces[1] is not wholly in view: it reaches beyond the screen on these sides: right; try -s "
     "'screen.width=5000' -s 'screen.height=4000'\n"},
    {"three-lights",
     {"surfaces[0].material.specular=0.001"},
     "surfaces[0]: the brightest place lies on the rim of what is seen of surfaces[0], so the peak is not wholly in "
     "view; try -s 'lights[2].position=[640, 320, 2300]'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 0 %: the peak hardly stands out; try -s "
     "'surfaces[0].material.specular=0.2'\n"},
    {"window",
     {"surfaces[0].material.specular=0.001"},
     "surfaces[0].material.specular: the highlight raises the maximum by only 0 %: the peak hardly stands out; try -s "
     "'surfaces[0].material.specular=0.1'\n"},
    {"tube",
     {"surfaces[0].material.specular=0.001"},
     "surfaces[0].material.specular: the highlight raises the maximum by only 0 %: the peak hardly stands out; try -s "
     "'surfaces[0].material.specular=0.1'\n"},
    {"two-spheres", {"lights[0].position=[210,130,1425]"}, ""},
    {"two-spheres", {"lights[0].position=[1300,-900,1000]"}, ""},
    {"three-lights",
     {"lights[0].intensity=0", "lights[1].intensity=0"},
     "lights[0].intensity: intensity = 0 lies outside the advised range 0.01 to 10000 W/sr; try -s "
     "'lights[0].intensity=0.01'\n"
     "lights[1].intensity: intensity = 0 lies outside the advised range 0.01 to 10000 W/sr; try -s "
     "'lights[1].intensity=0.01'\n"
     "surfaces[0]: the brightest place lies on the rim of what is seen of surfaces[0], so the peak is not wholly in "
     "view; try -s 'lights[2].position=[640, 320, 2300]'\n"
     "surfaces[0].material.specular: the highlight raises the maximum by only 0.4 %: the peak hardly stands out; try "
     "-s 'surfaces[0].material.specular=0.5'\n"},
    {"ball-lamp",
     {"surfaces[0].material.shininess=40000"},
     "surfaces[0].material.shininess: shininess = 40000 lies outside the advised range 1 to 500; try -s "
     "'surfaces[0].material.shininess=500'\n"},
    {"spot",
     {"lights[0].outer=5", "lights[0].aim=[0,280,600]"},
     "surfaces[0].material.specular: the highlight raises the maximum by only 0 %: the peak hardly stands out; try -s "
     "'lights[0].position=[600, -600, 2700]'\n"},
    {"1", {NULL}, ""},
    {"2", {NULL}, ""},
    {"3", {NULL}, ""},
    {"4", {NULL}, ""},
    {"5", {NULL}, ""},
    {"6", {NULL}, ""},
};

static void says(void **state)
{
    const char *wish = getenv("LUXEL_ADVICE");
    const bool prints = wish && strcmp(wish, "print") == 0;
    unsigned wrong = 0;
    (void)state;
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        luxel_scene *scene = opened_with(asked[i].scene, asked[i].changes, 2);
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        char said[ROOM] = "";
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        assert_int_equal(luxel_scene_advise_peak(scene, diagnostics), LUXEL_OK);
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++) {
            const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, k);
            char *message = luxel_diagnostics_message(diagnostics, k, NULL, NULL);
            char *hint = luxel_diagnostics_hint(diagnostics, k, NULL, NULL);
            snprintf(said + strlen(said), sizeof said - strlen(said), "%s: %s; %s\n", entry->key ? entry->key : "",
                     message, hint);
            luxel_text_free(message);
            luxel_text_free(hint);
        }
        bool same = strcmp(said, asked[i].said) == 0;
        wrong += !same;
        if (!same || prints)
            print_message("# %scase %zu\n%s# end\n", same ? "" : "changed: ", i, said);
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
