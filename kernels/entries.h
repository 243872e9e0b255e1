// Every kernel, once. ENTRY(name): the file kernels/<name>.cl, whose kernel calls <name>_pixels of kernels/<name>.h for RELUME_LANES neighbours.
#ifndef RELUME_ENTRIES_H
#define RELUME_ENTRIES_H

#define RELUME_ENTRIES(ENTRY) ENTRY(shade) ENTRY(evaluate) ENTRY(terms) ENTRY(directions) ENTRY(environment_sampled) ENTRY(environment_prefiltered)

#endif
