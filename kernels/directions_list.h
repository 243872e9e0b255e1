// The lecture's directions and the cosines between them, once: the planes that kernels/directions.h writes, in this order, are the layers of
// `relume directions`.
#ifndef RELUME_DIRECTIONS_LIST_H
#define RELUME_DIRECTIONS_LIST_H

#define RELUME_DIRECTIONS(DIRECTION) DIRECTION(n) DIRECTION(v) DIRECTION(l) DIRECTION(R_v) DIRECTION(R_l) DIRECTION(h)
#define RELUME_DIRECTION_COSINES(COSINE) COSINE(n_l) COSINE(n_v) COSINE(l_v) COSINE(n_h) COSINE(v_h) COSINE(R_v_l)

#endif
