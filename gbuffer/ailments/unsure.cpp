// Questions that the data answered with little margin.
#include "gbuffer/ailments/ailment.h"

namespace relume {
namespace {

void examine(const Patient& patient, std::vector<Check>&, std::vector<Finding>& findings) {
  for (const Verdict& verdict : patient.reading.verdicts)
    if (!verdict.sure)
      findings.push_back({"",
                          Severity::hint,
                          "",
                          {},
                          verdict.question + ": " + verdict.answer + ", but not sure: " + verdict.evidence,
                          "if it is the other, the whole picture is wrong",
                          verdict.option});
}

}  // namespace

extern const Ailment ailment_unsure;
const Ailment ailment_unsure{"unsure", "answers with little margin", examine};

}  // namespace relume
