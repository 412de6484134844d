#include "emit/generate.hpp"

#include <utility>

#include "base/files.hpp"

namespace vcrit::symbolic {

std::vector<std::filesystem::path> generate(const Scene& scene,
                                            const std::filesystem::path& directory,
                                            const std::string& name,
                                            const GenerateOptions& options) {
  // All texts first, so that an error leaves nothing half written.
  std::vector<std::pair<std::string, std::string>> texts{
      {name + ".hpp", emit_header(scene, name, options)},
      {name + "_batch.hpp", emit_batch_header(scene, name, options)}};
  if (options.quantities)
    texts.emplace_back(name + "_quantities.hpp", emit_quantities(scene, name, options));
  texts.emplace_back("test_" + name + ".cpp", emit_test(scene, name, options));
  texts.emplace_back("CMakeLists.txt", emit_cmake(name));
  std::vector<std::filesystem::path> files;
  for (const auto& [file, text] : texts) {
    files.push_back(directory / file);
    write_file(files.back(), text);
  }
  return files;
}

}  // namespace vcrit::symbolic
