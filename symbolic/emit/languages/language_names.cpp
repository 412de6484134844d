#include "emit/languages/language_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "base/errors.hpp"
#include "emit/names.hpp"

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

const char* const javascript_keywords =
    "arguments debugger eval extends implements instanceof interface null package super undefined";

// What CUDA's headers declare for everyone beside the C library.
const char* const cuda_names = R"(
threadIdx blockIdx blockDim gridDim warpSize dim3 min max norm norm3d norm4d normcdf
normcdfinv rnorm rnorm3d rnorm4d rhypot rsqrt rcbrt sinpi cospi sincospi erfinv erfcinv
erfcx clock clock64 abort assert printf cuda nvcuda cooperative_groups thrust cub
)";

bool is_among(const char* words, std::string_view name) {
  std::istringstream all(words);
  for (std::string word; all >> word;)
    if (word == name) return true;
  return false;
}

bool is_keyword(std::string_view name, Language language) {
  return (language == Language::python && is_among(python_keywords, name)) ||
         (language == Language::javascript && is_among(javascript_keywords, name));
}

bool is_taken_in_language(std::string_view name, Language language) {
  return (language == Language::python && is_among(python_modules, name)) ||
         (language == Language::cuda && is_among(cuda_names, name));
}

[[noreturn]] void refuse_in_language(const std::string& place, const std::string& name,
                                     const std::string& why, Language language) {
  throw InputError({place},
                   fmt::format("\"{}\", which is {} (--language {})", name, why,
                               language_names()[static_cast<std::size_t>(language)]),
                   "another name, of letters, digits and underscores");
}

}  // namespace

void check_library_name(const std::string& name, Language language) {
  check_library_name(name);
  if (is_keyword(name, language)) refuse_in_language("--name", name, "a reserved word", language);
  if (is_taken_in_language(name, language)) refuse_in_language("--name", name, "taken", language);
}

void check_member_names(const Scene& scene, const std::vector<Symbol>& symbols, Language language) {
  check_member_names(scene, symbols);
  for (const Symbol& symbol : symbols)
    if (const std::string name = as_called(scene, symbol).name; is_keyword(name, language))
      refuse_in_language(scene.file, name, "a reserved word", language);
}

}  // namespace vcrit::symbolic
