#include "emit/generate.hpp"

#include "base/files.hpp"

namespace vcrit::symbolic {

void generate(const Scene& scene, const std::filesystem::path& directory, const std::string& name,
              const GenerateOptions& options) {
  // All texts first, so that an error leaves nothing half written.
  const std::string header = emit_header(scene, name, options);
  const std::string batch = emit_batch_header(scene, name, options);
  const std::string test = emit_test(scene, name, options);
  const std::string cmake = emit_cmake(name);
  const std::string quantities = options.quantities ? emit_quantities(scene, name, options) : "";
  write_file(directory / (name + ".hpp"), header);
  write_file(directory / (name + "_batch.hpp"), batch);
  if (options.quantities) write_file(directory / (name + "_quantities.hpp"), quantities);
  write_file(directory / ("test_" + name + ".cpp"), test);
  write_file(directory / "CMakeLists.txt", cmake);
}

}  // namespace vcrit::symbolic
