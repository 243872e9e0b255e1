// Where Cycles' lobes find the directional albedo of GGX in the table buffer; host/ggx_albedo makes it.
#ifndef RELUME_CYCLES_TABLES_H
#define RELUME_CYCLES_TABLES_H

// Entry [n.v][roughness] and [roughness], both evenly spaced from 0 to 1.
#define RELUME_CYCLES_TABLE_SIDE 32
#define RELUME_CYCLES_E_START 0
#define RELUME_CYCLES_E_MEAN_START 1024
#define RELUME_CYCLES_TABLES_LENGTH 1056

#endif
