// Every question that the data are asked, in order: what a file does not say is found out by a file in this folder and one line here.
// QUESTION(name): the file <name>.cpp defines `void ask_<name>(const Asked&, Reading&)`, which settles the reading and adds a verdict. It leaves
// alone what the user has said, and where two answers are nearly as good it keeps the convention's.
#pragma once

#define RELUME_QUESTIONS_BEFORE_CAMERA(QUESTION) \
  QUESTION(normal_encoding)                      \
  QUESTION(position_space)

#define RELUME_QUESTIONS_WITH_CAMERA(QUESTION) \
  QUESTION(premultiplication)                  \
  QUESTION(depth_kind)                         \
  QUESTION(normal_space)
