/* SPDX-License-Identifier: MIT */
/* Vectors in space, one for each element of a vector of elements, in one precision.  Included behind each lanes.h. */

/* A vector in space for each of some elements. */
struct NAME(space) {
    NAME(lanes) x, y, z;
};

LX_LANE struct NAME(space) NAME(same)(const REAL v[3])
{
    return (struct NAME(space)){NAME(all)(v[0]), NAME(all)(v[1]), NAME(all)(v[2])};
}

LX_LANE NAME(lanes) NAME(dot)(struct NAME(space) a, struct NAME(space) b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

LX_LANE struct NAME(space) NAME(cross)(struct NAME(space) a, struct NAME(space) b)
{
    return (struct NAME(space)){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/* a + factor b */
LX_LANE struct NAME(space) NAME(along)(struct NAME(space) a, NAME(lanes) factor, struct NAME(space) b)
{
    return (struct NAME(space)){a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

LX_LANE struct NAME(space) NAME(sum_of)(struct NAME(space) a, struct NAME(space) b)
{
    return (struct NAME(space)){a.x + b.x, a.y + b.y, a.z + b.z};
}

LX_LANE struct NAME(space) NAME(times)(NAME(lanes) factor, struct NAME(space) a)
{
    return (struct NAME(space)){factor * a.x, factor * a.y, factor * a.z};
}

/* Where a > b, `above`, elsewhere `other`. */
LX_LANE struct NAME(space)
    NAME(space_where_above)(NAME(lanes) a, NAME(lanes) b, struct NAME(space) above, struct NAME(space) other)
{
    return (struct NAME(space)){NAME(where_above)(a, b, above.x, other.x), NAME(where_above)(a, b, above.y, other.y),
                                NAME(where_above)(a, b, above.z, other.z)};
}
