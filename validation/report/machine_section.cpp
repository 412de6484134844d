#include "report/machine_section.hpp"

#include <fmt/core.h>

#include "report/html.hpp"

namespace vcrit::validation::report {

std::string machine_section(const Origin& origin) {
  const Machine& machine = origin.machine;
  const auto row = [](const std::string& name, const std::string& value) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", escape(name),
                       escape(value));
  };
  std::string rows = row("Processor", machine.processor) +
                     row("Cores", std::to_string(machine.cores)) + row("System", machine.system) +
                     row("vcrit", machine.program + ", commit " + machine.commit) +
                     row("Compiled with", machine.compiler_flags);
  for (const auto& [name, version] : machine.versions) rows += row(name, version);
  return fmt::format(
      "<section class=\"machine\"><h2>How this page was made</h2>\n"
      "<p>This command makes it again; the same numbers are in <code>report.json</code> beside "
      "it.</p>\n<pre class=\"command\" tabindex=\"0\"><code>{}</code></pre>\n"
      "<table class=\"plain\"><tbody>\n{}</tbody></table></section>\n",
      escape(origin.command), rows);
}

}  // namespace vcrit::validation::report
