// SPDX-License-Identifier: MIT
// The lessons in English.  Blocks are parted by empty lines: # title, > lead, ## heading, @figure name | caption,
// @formula figure, @guess what happens | question | why, @check task | question | why | hint; all else is a paragraph, with
// *names*, **vectors** and $formulas$.
import type { LessonWords } from './lesson';

export const ENGLISH: LessonWords = {
    labels: {
        a: 'Ambient light', x: 'Aside', y: 'Up', h: 'Height', k: 'Length k', s: 'Height of the sun', d: 'Distance',
        o: 'Outer angle', b: 'Inner angle', w: 'Width', p: 'Parts each way', R: 'Radius', n: 'Exponent n', ks: 'Highlight ks',
    },
    chapters: {
        ambient: `
# Ambient light

> On a dull day light comes from everywhere. It has no source and no direction, and every surface gets the same of it, whichever way it looks.

Real light of this kind is what sky, walls and ground have passed on to each other many times. A picture that would follow each of these ways would take long, so computer graphics replaces them all by one number, $E_a$, the illuminance that everything receives.

Slide it. The ring on the table is the place whose illuminance is told.

@figure alone | Nothing but ambient light. Ball and block have an outline, and no shape.

@formula alone

@guess The table receives what you see above. The wall stands upright. | What does the wall receive?  | Ambient light has no direction, so no cosine weakens it: table, wall and ball receive the same.

## What gives shape

A surface looks round when its parts receive different amounts. Ambient light alone gives all of them the same, so it shows no relief. Add one bulb and the ball becomes a ball; the ambient light now only fills the shadows.

@figure relief | A bulb and ambient light together. The curve is the illuminance along the dashed line: ambient light lifts all of it by the same amount.

Light adds up. What two sources give at a place is the sum of what each gives alone, and ambient light is one more term of this sum:

$E = E_a + E_1 + E_2$

@check Ambient light of 40 lx, and a bulb that alone gives 60 lx straight below it. | How many lux does the ring below the bulb receive? | The two add up. | Light of two sources adds up.
`,
        point: `
# Point source and inverse square

> A bulb that is small beside its distance sends its light out evenly. What reaches a table depends on two things only: how far away the bulb is, and how squarely its light arrives.

Take the lamp and move it. The ring on the table shows the place where the light is measured; the number follows your hand.

@figure bulb | A bulb of 60 cd over a table. The illuminance *E* is what the table receives, in lux.

@formula bulb

*I* is the intensity of the bulb in candelas, *r* the distance in metres, and **N** · **L** the cosine of the angle between the table's normal and the direction to the lamp. A slanting beam covers more of the table, so each part of it gets less. Where the cosine is negative the lamp is behind the surface and gives nothing.

## How far away

The light that leaves the bulb spreads over a sphere, whose area grows as the square of its radius.

@guess The bulb hangs 0.5 m above the ring. You raise it to 1 m. | What will the number be? | At twice the distance the same light covers four times the area, so a square metre gets a quarter of it.

Now look. Pull the bulb up and down along its thread; the point on the curve is your lamp.

@figure lift | The same bulb straight above. Twice as far, a quarter of the light.

@formula lift

@check The bulb of 60 cd hangs 0.8 m high and 0.6 m to the side. | How many lux does the ring receive? Three digits are enough. | The distance is 1 m and the cosine 0.8. | Find *r* by Pythagoras, then the cosine as height over *r*.
`,
        practical: `
# Why 1/(k + r)

> The inverse square is true, and awkward: beside the lamp it grows without end, and far from it a picture goes black. Computer graphics often uses a gentler law instead.

$E = \\frac{I}{k + r} (\\v{N}·\\v{L})$

The length *k* keeps the law finite: in the lamp itself, at *r* = 0, it gives *I*/*k* and no more. Far away it falls as 1/*r*, half as steep as the true law on paper with logarithmic axes.

@guess A bulb of 60 cd comes down from 0.5 m to 0.1 m; *k* is 0.5 m. By the inverse square the light would grow 25 times. | What does the practical law give? | The sum *k* + *r* falls only from 1.0 to 0.6 m.

Pull the lamp down until it nearly touches the table, and compare the two curves.

@figure laws | The practical law (solid, with your lamp on it) and the inverse square (thin). They cross beyond one metre: nearer the practical law gives less, farther away more.

@formula laws

## A lamp close to a surface

Where a lamp passes close to a wall the inverse square makes a glaring spot, and all the rest of the picture is dark beside it. The practical law keeps both within the range of a screen. The price: the numbers are no longer those of a light meter.

@figure near | A lamp 15 cm above the table. The curves are the light along the dashed line by both laws.

@check The bulb of 60 cd hangs 0.7 m above the ring, and *k* is 0.5 m. | What does the practical law give? | 60 is divided by 1.2. | Add *k* and *r*, both in metres.
`,
        distant: `
# Distant source

> The sun is so far away that its rays reach all of the table from one direction, and equally strong. Only the tilt of the surface matters.

Take the sun and lead it across the sky.

@figure sun | Sunlight of 800 lx on a surface that faces it. The curve is the illuminance of the table over the sun's height, from one horizon to the other.

@formula sun

There is no *r* in this formula: nothing on the table is nearer to the sun than anything else. What is left is the cosine between the normal and the fixed direction, which for a level table is the sine of the sun's height.

@guess At noon the sun stands overhead. In the evening it is 30° high. | What does the table receive then? | The sine of 30° is one half.

## From near to far

A distant source is a point source that has been moved away, and made so much stronger that the light at the ring stays the same. Move it, and watch the curve grow flat.

@figure far | A lamp above the table, whose intensity grows with the square of its distance. The curve is the illuminance along the dashed line.

From some ten times the size of the table on, the difference is hardly seen, and a direction is enough.

@check The sun stands 45° high; a surface facing it receives 800 lx. | What does the table receive? Three digits are enough. | The sine of 45° is 0.7071. | The cosine of the angle to the table's normal counts.
`,
        cone: `
# Cone of light

> A spotlight is a point source that shines within a cone: full on the axis, nothing outside, and falling in between.

Take the point it is aimed at and lead the spot over the table.

@figure aim | A spotlight of 400 cd along its axis. It is full within half the outer angle and falls to nothing at the edge.

@guess The spot is aimed at the ring. You narrow the cone from 30° to 15°, and its intensity stays the same. | What happens at the ring? | On the axis the intensity and the distance are as before. The cone only decides who is left out.

## Between axis and edge

Two angles shape the beam. Within the inner angle the intensity is full; outside the outer one there is nothing; between them it falls smoothly. If both are equal the spot has a sharp edge, like that of a stencil.

@figure edge | A spotlight straight above, moved aside. Slide the inner angle up to the outer one, 30°, and the edge on the curve becomes a cliff.

@formula edge

All else is as with the point source: the intensity in the direction of the place, divided by the square of the distance, times the cosine of the surface.

@check The spot of 400 cd hangs 1 m high and 0.2 m to the side, and shines straight down. The ring is within its inner angle of 20°. | How many lux does the ring receive? Three digits are enough. | The distance squared is 1.04, and the cosine 0.9806. | The ring gets the full 400 cd, from the side: take *r* and the cosine as with a bulb.
`,
        area: `
# Area source, and when to divide it

> A window or a panel shines mainly ahead and less to the sides. Far away it counts as one point; near, it must be divided into parts.

From afar a panel is a point with a pattern. Two cosines count now: that of the surface, and that of the panel with its own normal **M**, because seen from the side the panel looks narrow.

@figure panel | A panel of 60 cd along its normal, facing down. Make it small, and the formula becomes exact.

@formula panel

## Near

The formula takes all light as coming from the middle of the panel. Close to a large panel that is wrong: its corners are far away, and their light comes in slanting.

@guess A panel one metre wide hangs 0.2 m above the ring. The formula for a point gives 60 divided by 0.2², 1500 lx. | What does the ring really receive? | Most of the panel is farther away than 0.2 m and seen at a slant. The formula is off many times.

@figure near | The true light of the panel (solid) and that of a point in its middle (thin). From five times the width on they agree within a per cent or so.

## Dividing

The remedy: cut the panel into parts, each small beside its distance, and add them up. Slide the number of parts and watch the hills melt into the true curve.

@figure parts | A panel one metre wide, 0.2 m above the table, as so many points each way (solid); the sum of infinitely many is the thin curve.

@check A small panel of 60 cd faces down, 1 m high and 1 m to the side of the ring. | How many lux does the ring receive? Three digits are enough. | 60 over a squared distance of 2, times one half for the two cosines. | Both cosines are the same here: table and panel look along the vertical.
`,
        volume: `
# Volume source

> A lamp shade shines outwards all over. Computer graphics takes it as a convex body, each face of which is an area source.

@figure globe | An opal globe of 754 lm. Slide its radius, and watch the number.

@formula globe

@guess A globe of radius 5 cm is replaced by one of 20 cm, of the same luminous flux, with its centre at the same place. | What does the ring below it receive? | A sphere that shines evenly gives, wherever all of its visible part is above the horizon, just what a point in its centre gives. Large or small, the light is the same; the shadows are softer.

## Faces

A box is no sphere. Each of its faces is an area source of its own, which gives light only ahead: below the box only the bottom counts, aside of it one side more. What a face hides from a place gives nothing there, and as the body is convex, no face hides another.

@figure box | A luminous box of 500 cd/m². The curve shows how it shines along the table.

Move the box aside and watch the ring pass from the light of one face into that of two. A cylinder or any other convex body is done in the same way: it becomes a polyhedron of many faces, and their light is added up.

@check The globe of 754 lm hangs 1.2 m above the ring. | How many lux does the ring receive? Three digits are enough. | The intensity is the flux over 4π, 60 cd, divided by 1.44. | First the intensity: flux over the full solid angle 4π.
`,
        reflection: `
# Reflected light and Blinn–Phong

> What we see of a surface is not what it receives, but what it sends to our eye. A matt part goes to all sides alike; a shining part goes mainly where a mirror would send it.

This is the sphere of the exercise, seen along the axis, under a source of 10 W/sr without attenuation. Take the source and move it.

@figure ball | Brightness of the sphere at its middle, which faces us. The highlight follows the source, half as fast.

@formula ball

**N** is the normal, **L** points to the source, **V** to the eye. **H** lies halfway between **L** and **V**: $\\v{H} = \\frac{\\v{L} + \\v{V}}{|\\v{L} + \\v{V}|}$. Where the normal points along **H** the surface stands like a mirror that shows us the source, and the highlight has its peak. The exponent *n* says how quickly it falls beside that.

@guess The source stands straight before the sphere, so that **N**, **L**, **V** and **H** are one at its middle. You raise *n* from 20 to 80. | What happens to the brightness at the middle? | One to any power is one. The exponent makes the highlight narrower, not brighter.

## Peak

The curve is the brightness along the dashed line, whole and without the highlight. The diffuse part has its top where the surface faces the source, the highlight where it faces **H**.

@figure peak | Slide the weight *ks* and the exponent *n*: the peak grows, and grows narrow.

@check A source of 10 W/sr stands at (560, 300, 2000) mm; the middle of the sphere is at (0, 0, 1300). *kd* = 0.8, *ks* = 0.5, *n* = 20. | How bright is the middle? Three digits are enough. | The cosine of **N** and **L** is 0.7405, and that of **N** and **H** 0.9329. | **V** is (0, 0, 1) here; find **L**, then **H**, then both cosines.
`,
    },
};
