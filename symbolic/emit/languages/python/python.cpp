// The Python module: NumPy's arithmetic on pairs of arrays.
#include <fmt/core.h>

#include "base/joined.hpp"
#include "emit/languages/language.hpp"
#include "emit/languages/sections.hpp"
#include "emit/pieces.hpp"

VCRIT_ARITHMETIC(python)

namespace vcrit::symbolic {

namespace {

// Those that are reserved in C++ as well are refused as names of a scene.
const char* const python_keywords = "None True False as";

// A file of such a name would be imported in the place of Python's own module or of NumPy.
const char* const python_modules = R"(
abc aifc antigravity argparse array ast asynchat asyncio asyncore atexit audioop base64
bdb binascii bisect builtins bz2 cProfile calendar cgi cgitb chunk cmath cmd code codecs
codeop collections colorsys compileall concurrent configparser contextlib contextvars
copy copyreg crypt csv ctypes curses dataclasses datetime dbm decimal difflib dis
distutils doctest email encodings ensurepip enum errno faulthandler fcntl filecmp
fileinput fnmatch fractions ftplib functools gc genericpath getopt getpass gettext glob
graphlib grp gzip hashlib heapq hmac html http idlelib imaplib imghdr imp importlib
inspect io ipaddress itertools json keyword lib2to3 linecache locale logging lzma
mailbox mailcap marshal math mimetypes mmap modulefinder msilib msvcrt multiprocessing
netrc nis nntplib nt ntpath nturl2path numbers numpy opcode operator optparse os
ossaudiodev pathlib pdb pickle pickletools pipes pkgutil platform plistlib poplib posix
posixpath pprint profile pstats pty pwd py_compile pyclbr pydoc pydoc_data pyexpat queue
quopri random re readline reprlib resource rlcompleter runpy sched secrets select
selectors shelve shlex shutil signal site smtpd smtplib sndhdr socket socketserver spwd
sqlite3 sre_compile sre_constants sre_parse ssl stat statistics string stringprep struct
subprocess sunau symtable sys sysconfig syslog tabnanny tarfile telnetlib tempfile
termios textwrap this threading time timeit tkinter token tokenize tomllib trace
traceback tracemalloc tty turtle turtledemo types typing unicodedata unittest urllib uu
uuid venv warnings wave weakref webbrowser winreg winsound wsgiref xdrlib xml xmlrpc
zipapp zipfile zipimport zlib zoneinfo
)";

std::string python_operations(const Evaluator& evaluator) {
  const Sections& sections = python_sections();
  return sections["numbers"] + (evaluator.velocity.rooted ? sections["root"] : "") +
         sections["within"] + sections.rare_operations(evaluator.gradient.program);
}

/// A statement of any length has to stand on one line.
std::string python_lines(const std::vector<StraightLine::Declarations>& declarations) {
  std::string out;
  for (const auto& [kind, items] : declarations)
    for (const std::string& item : items) out += "    " + item + "\n";
  return out;
}

std::string parameters_class(const ParameterList& parameters) {
  std::string out = "@dataclass(eq=False)\nclass Parameters:\n    \"\"\"" + meanings(parameters) +
                    "\n\n    Numbers, or arrays, which broadcast.\n    \"\"\"\n\n";
  for (const Member& member : parameters.members())
    out += fmt::format(
        "    {}: Any{}\n", member.name,
        member.length == 0 ? "" : fmt::format("  # a sequence of {} of them", member.length));
  return out;
}

/// "Parameters(given(p.mu0), [given(x) for x in ...])" and its inverse from a list of all entries.
std::string conversions(const ParameterList& parameters) {
  std::vector<std::string> given, gathered;
  int next = 0;
  for (const Member& member : parameters.members()) {
    if (member.length == 0) {
      given.push_back(fmt::format("_array(p.{})", member.name));
      gathered.push_back(fmt::format("x[{}]", next++));
      continue;
    }
    given.push_back(fmt::format("_arrays(p.{}, {})", member.name, member.length));
    gathered.push_back(fmt::format("x[{}:{}]", next, next + member.length));
    next += member.length;
  }
  return fmt::format(
      "def _given(p):\n    return Parameters(\n        {},\n    )\n\n\n"
      "def _gathered(x):\n    return Parameters(\n        {},\n    )\n",
      joined(given, ",\n        "), joined(gathered, ",\n        "));
}

std::string python_evaluation(const Evaluator& evaluator, CallGrade grade,
                              const Spelling& spelling) {
  const CallDialect dialect(evaluator.parameters, grade, spelling);
  const FunctionBody code = body(evaluator, dialect);
  const std::string kind = grade == CallGrade::accurate ? "dd" : "plain";
  return fmt::format("\n\ndef _{}_evaluate(p, gradient):\n", kind) + python_lines(code.value) +
         fmt::format("    r = _{}_finished({}, {}, {}, {}, _in_range(p))\n", kind, code.above,
                     code.below, code.factor, code.roundings) +
         "    if not gradient:\n        return r\n" + python_lines(code.gradient) +
         fmt::format("    return r._replace(partial=[\n        {},\n    ])\n",
                     joined(code.partials, ",\n        "));
}

std::string python_text(const Evaluator& evaluator, const std::string&) {
  const Sections& sections = python_sections();
  const Spelling spelling{"_", "np.abs", "np.sqrt", false, Zeros::in_range};
  const bool rooted = evaluator.velocity.rooted;
  std::string out =
      sections["imports"] + parameters_class(evaluator.parameters) + sections["tuples"];
  out += conversions(evaluator.parameters) + python_operations(evaluator);
  out += "\n\ndef _in_range(p):\n    return (\n        " +
         in_range(evaluator, spelling, "\n        & ", "np.False_") + "\n    )\n";
  out += replaced(replaced(sections["finished"], "THE_SQUARE_ROOT", rooted ? "np.sqrt" : ""),
                  "THE_ROOT", rooted ? "_dd_root" : "");
  out += python_evaluation(evaluator, CallGrade::accurate, spelling);
  out += python_evaluation(evaluator, CallGrade::fast, spelling);
  return out + evaluator.parameters.named(sections["calls"]);
}

}  // namespace

extern const Language python{.name = "python",
                             .extension = ".py",
                             .comment = "#",
                             .zeros = Zeros::in_range,
                             .reserved = python_keywords,
                             .taken = python_modules,
                             .text = python_text};

}  // namespace vcrit::symbolic
