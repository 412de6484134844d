// vcrit new: a scene with comments, to be filled in.
#include "scene/new_scene.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/files.hpp"
#include "choice.hpp"
#include "commands.hpp"
#include "options.hpp"
#include "record/fields.hpp"

namespace vcrit::app {

namespace {

constexpr const char* rigid_drive = "rigid";

struct NewSceneOptions {
  std::string file, rheology, drive;
  bool mass = false, separation = false, json = false;
};

struct WrittenScene {
  std::optional<std::string> file;
  NewScene scene;
  std::string text;

  friend void fields(record::Fields& f, const WrittenScene& it) {
    f("file", it.file)("rheology", it.scene.rheology);
    f("drive", it.scene.drive.value_or(rigid_drive))("body", it.scene.has_body);
    f("separation", it.scene.may_open)("numbers_to_fill_in", numbers_to_fill_in(it.text));
    f("text", it.text);
  }
};

void refuse_to_write_over(const std::string& file) {
  std::error_code error;
  if (std::filesystem::symlink_status(file, error).type() == std::filesystem::file_type::not_found)
    return;
  throw InputError({file}, "a file of that name", "a new one", "vcrit new writes over nothing");
}

WrittenScene written(const NewSceneOptions& options) {
  const std::optional<std::string> drive =
      options.drive == rigid_drive ? std::nullopt : std::optional(options.drive);
  const NewScene scene{options.rheology, drive, options.mass, options.separation};
  WrittenScene result{{}, scene, new_scene_text(scene)};
  if (options.file.empty()) return result;
  refuse_to_write_over(options.file);
  write_file(options.file, result.text);
  result.file = options.file;
  return result;
}

void print_written(const WrittenScene& scene) {
  if (!scene.file) return fmt::print("{}", scene.text);
  fmt::print(
      "Wrote {}: contact {}, drive {}{}.\nFill in the {} numbers marked \"{}\"; then: vcrit "
      "check {}\n",
      *scene.file, scene.scene.rheology, scene.scene.drive.value_or(rigid_drive),
      scene.scene.has_body ? ", with a body" : "", numbers_to_fill_in(scene.text), to_be_filled_in,
      *scene.file);
}

}  // namespace

void add_new(CLI::App& program) {
  const auto options = std::make_shared<NewSceneOptions>();
  CLI::App* command = program.add_subcommand(
      "new", "A scene to fill in, with typical values and where to find them");
  command->add_option("FILE", options->file, "the scene; printed where no file is given");
  Choices<std::string> contacts, drives{{rigid_drive, rigid_drive}};
  for (const std::string& name : rheologies_of_parts()) {
    drives.emplace_back(name, name);
    contacts.emplace_back(name, name);
  }
  std::stable_partition(contacts.begin(), contacts.end(),
                        [](const auto& each) { return each.first == "zener"; });
  options->rheology = contacts.front().first;
  options->drive = rigid_drive;
  add_choice(*command, "--rheology", options->rheology, contacts, "network of the contact");
  add_choice(*command, "--drive", options->drive, drives, "network of the drive");
  command->add_flag("--mass", options->mass, "a body between contact and drive");
  command->add_flag("--separation", options->separation, "the contact may open");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    const WrittenScene scene = written(*options);
    if (options->json)
      print(record::json_of(scene));
    else
      print_written(scene);
  });
}

}  // namespace vcrit::app
