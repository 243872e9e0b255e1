// What the host hands to a kernel: plain ints and floats only, the same bytes in OpenCL C and C++.
#ifndef RELUME_FRAME_H
#define RELUME_FRAME_H

#include "kernels/choice.h"
#include "kernels/parameters.h"

enum { FALLOFF_inverse_square, FALLOFF_windowed, FALLOFF_linear, FALLOFF_none };
enum { WIDTH_alpha, WIDTH_roughness, WIDTH_exponent, WIDTH_chord_exponent };
enum { CONE_gltf, CONE_smoothstep, CONE_linear };

/// Pixels that share a list of lights: the most that any device shades at once.
#define RELUME_LISTED_PIXELS 16

/// 64 bytes: one light. A type ignores what it does not need.
typedef struct {
  float position[3];    // world
  float falloff_scale;  // linear: 1/(range - range_begin); windowed: 1/range^2
  float intensity[3];   // W/sr; directional: W/m^2
  float range;          // world units; 0 = unbounded
  float direction[3];   // unit, the way the light travels
  float outer;          // cosine of the outer half-angle; cone linear: the angle, radians
  float inner;          // cosine of the inner half-angle; cone linear: the angle, radians
  int falloff;
  int cone;
  float reach;  // the least distance from which nothing arrives, with a margin of 1e-4 for rounding; infinity where light arrives from anywhere
} LightRecord;

#define RELUME_FIELD_NUMBER(name, ...) FIELD_##name,
enum { RELUME_PARAMETERS(RELUME_FIELD_NUMBER) FIELD_coverage, FIELD_facing, FIELD_COUNT };

/// Where a parameter of a pixel lies in the planes: plane data (step 1) or one value for all pixels (step 0).
typedef struct {
  int offset;          // floats from the start of the planes
  int step;            // floats from a pixel to the next: 1 or 0
  int component_step;  // floats from a component to the next
} Field;

/// Work-items of a group that takes its lights into local memory (kernels/staged_lights.h).
#define RELUME_STAGED_ITEMS 64

/// Pixels of a cell, for which lights are listed together, and the most parts that it is bounded in.
#define RELUME_CELL_PIXELS 128
#define RELUME_CELL_PARTS 4

/// Of some pixels that show a surface: positions within a box, normals within another. Nothing where low > high.
typedef struct {
  float low[3], high[3];                // positions, world
  float normal_low[3], normal_high[3];  // as shaded: turned towards the viewer where the surface has two sides
  float reference[3];                   // a point near them, q
  float deepest;                        // least n.(p - q)
} PixelBounds;

/// A latitude-longitude image in the tables; its frame has the pole at z and the left edge at x.
typedef struct {
  int width, height;              // texels
  float column_shift, row_shift;  // from the left edge, from the pole to the first texel's centre, texels
  float row_steps;                // texel heights from pole to pole
  int texels;                     // where in the tables they begin: W/(m^2 sr) r, g, b, row by row
} EnvironmentImage;

/// An environment for a kernel that samples it, or looks it up prefiltered. Places in the tables are their first entry's.
typedef struct {
  EnvironmentImage image;
  float world_from_map[9];  // row by row
  // Sampled (kernels/environment/draw.h):
  int row_density;                // of each row: what a texel's luminance is multiplied by, to give its share of the density of samples
  int row_shares, column_shares;  // of the texels' light, up to and with each row, and each texel of a row: cumulative, the last is 1
  int points;                     // v of each sample
  int samples;                    // a multiple of 16
  int scramble;                   // plane index, 2 planes: what is added to the points of each pixel, 0..1
  // Prefiltered (kernels/environment_prefiltered.h):
  int harmonics;           // 9 times r, g, b of the irradiance's polynomial
  EnvironmentImage level;  // the first of the levels, which follow each other
  int levels;              // for lobes of the widths (1/levels)^2, (2/levels)^2, ... 1
} EnvironmentRecord;

typedef struct {
  int pixels;         // in this band, without padding
  int plane_stride;   // floats from one plane to the next
  int program;        // the value of the program plane that this launch shades
  int program_plane;  // plane index; -1 in it means no surface
  int position;       // plane index, 3 planes
  int normal;         // plane index, 3 planes
  int base_normal;    // plane index, 3 planes; -1: none
  int bump_shadowing;
  float viewer[4];   // the eye, 1; or the unit direction to an orthographic viewer, 0
  float ambient[4];  // radiance from everywhere, rgb; the fourth is 0 where there is none
  int nodes;         // ambient's quadrature in the tables: node_count times u, cos phi, sin phi, weight
  int node_count;
  int width_rule;                             // WIDTH_*: where the specular lobe's width is found
  int light_begin[LIGHT_COUNT + 1];           // lights are sorted by type: [begin[t], begin[t + 1])
  int lists;                                  // where in the lists the blocks' own lights are told (host/light_lists.h); 0: every light is met
  int total, diffuse, specular, ambient_out;  // plane indices in the output, 3 planes each; -1: not wanted
  int error;                                  // plane index in the output of the squared error that is estimated; -1: not wanted
  EnvironmentRecord environment;              // for the programs of kernels/environment
  int out_stride;                             // floats from one output plane to the next
  int sums;  // plane index in the output, 6 planes: diffuse and specular sums as they are before coverage; 0: not wanted
  int base;  // the same, of other lights: what is added to. Blocks whose list begins below 0 are left as they are. 0: none
  Field field[FIELD_COUNT];
} Frame;

#endif
