// find_objects: a Cryptomatte knows names alone, even where they are digits; other layers know numbers alone.
#include "host/material_objects.h"

#include "gbuffer/error.h"
#include "host/json.h"

namespace relume {

void find_objects(MaterialFile& materials, const ExrFile& file, Reading& reading, const std::string& place) {
  if (materials.by_id.empty() && materials.by_name.empty()) return;
  ObjectIds& objects = materials.objects.emplace(file, reading, materials.ids, !materials.by_name.empty());
  if (objects.is_cryptomatte())
    for (auto& [id, material] : materials.by_id) materials.by_name.try_emplace(std::to_string(id), std::move(material));
  std::vector<std::string> names;
  if (!objects.is_cryptomatte())
    for (const auto& [id, material] : materials.by_id) names.push_back(std::to_string(id));
  for (const auto& [name, material] : materials.by_name) names.push_back(name);
  const std::vector<std::uint32_t> ids = objects.ids_of(names, place);
  if (!objects.is_cryptomatte()) return;
  materials.by_id.clear();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!materials.by_id.emplace(ids[i], std::move(materials.by_name.at(names[i]))).second)
      throw Error(ErrorKind::input,
                  place + ": " + in_quotes(names[i]) + " is the same object as another entry: their ids are alike (" + objects.called(ids[i]) + ")");
}

}  // namespace relume
