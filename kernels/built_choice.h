// The choice that a program on a device is built for, from names given as macros: -DRELUME_DIFFUSE=lambert and so on.
#ifndef RELUME_BUILT_CHOICE_H
#define RELUME_BUILT_CHOICE_H

#include "kernels/choice.h"

#define RELUME_NUMBER_(kind, name) kind##_##name
#define RELUME_NUMBER(kind, name) RELUME_NUMBER_(kind, name)

static Choice built_choice(void) {
  Choice choice;
  choice.diffuse = RELUME_NUMBER(DIFFUSE, RELUME_DIFFUSE);
  choice.specular = RELUME_NUMBER(SPECULAR, RELUME_SPECULAR);
  choice.fresnel = RELUME_NUMBER(FRESNEL, RELUME_FRESNEL);
  choice.shadowing = RELUME_NUMBER(SHADOWING, RELUME_SHADOWING);
  choice.distribution = RELUME_NUMBER(DISTRIBUTION, RELUME_DISTRIBUTION);
  return choice;
}

#endif
