// The questions, one after the other over one sample.
#include "gbuffer/solver/solve.h"

#include "gbuffer/samples.h"
#include "gbuffer/solver/list.h"
#include "gbuffer/solver/question.h"

namespace relume {

#define RELUME_DECLARE(name) void ask_##name(const Asked& asked, Reading& reading);
RELUME_QUESTIONS_BEFORE_CAMERA(RELUME_DECLARE)
RELUME_QUESTIONS_WITH_CAMERA(RELUME_DECLARE)

#define RELUME_ASK(name) ask_##name(asked, reading);

void solve_before_camera(Samples& samples, const ReadingOptions& options, Reading& reading) {
  const Asked asked{samples.file(), samples.bands(reading), options};
  RELUME_QUESTIONS_BEFORE_CAMERA(RELUME_ASK)
}

void solve_with_camera(Samples& samples, const ReadingOptions& options, Reading& reading) {
  const Asked asked{samples.file(), samples.bands(reading), options};
  RELUME_QUESTIONS_WITH_CAMERA(RELUME_ASK)
}

}  // namespace relume
