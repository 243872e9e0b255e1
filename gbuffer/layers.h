// Channel names taken apart: "ViewLayer.Normal.left.X" is view layer, layer, view and component (OpenEXR naming; research: exr-conventions 0.2).
#pragma once

#include <string>
#include <vector>

#include "gbuffer/exr_file.h"

namespace relume {

struct Component {
  char letter;          ///< lower case, short: r g b a x y z u v w t i, or 0 for a bare channel such as "Z", "dzdx"
  std::string channel;  ///< the full name in the file
  SampleType type;
};

struct Layer {
  int part = 0;
  std::string view_layer;  ///< Blender's ("ViewLayer", "Set only"); empty elsewhere
  std::string name;        ///< "Normal", "sh_normal"; empty for root channels R G B A
  std::string view;        ///< stereo: "left"; empty elsewhere
  std::vector<Component> components;

  const Component* component(char letter) const;
  /// The channels of a direction or a colour, in order: x y z, r g b (red, green, blue too) or u v w (MoonRay); empty if there are not three.
  std::vector<std::string> triple() const;
};

/// Every layer of every part, in file order.
std::vector<Layer> layers_of(const ExrFile& file);

/// What shows that Blender wrote the file, or empty: only then does a channel's name begin with a view layer.
std::string blender_marks(const ExrFile& file);

std::string lower(std::string text);

/// Lower case, without spaces, '_' and '-': what aliases are compared by.
std::string normalised(const std::string& layer_name);

}  // namespace relume
