// Words that plots of all kinds share.
#include "lab/plot.h"

namespace relume {

std::string PlotRequest::label(const Subject& subject, LobePart part) const {
  const std::string name = compared.label(subject);
  return parts.size() > 1 ? name + ", " + name_of(part) : name;
}

std::string plain(const std::string& text) {
  std::string marked;
  for (const char c : text) {
    if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) marked += '\\';
    marked += c;
  }
  return marked;
}

std::string title_command(const PlotRequest& request, const std::string& first_line) {
  const std::string constants = request.compared.constants();
  return "set title " + quoted(first_line) + (constants.empty() ? "" : ".\"\\n{/*0.85 \"." + quoted(plain(constants)) + ".\"}\"") + "\n";
}

}  // namespace relume
