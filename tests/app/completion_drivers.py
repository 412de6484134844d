"""What bash and zsh really offer: the shells are run with the program's completion loaded."""

import os
import pty
import select
import subprocess
import time

BASH = r"""
source "$1"
shift
[[ $(complete -p vcrit) == *'-F _vcrit vcrit' ]] || echo 'not registered' >&2
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_vcrit
((${#COMPREPLY[@]} == 0)) || printf '%s\n' "${COMPREPLY[@]}"
"""

# Shows each candidate of a listing between two marks, with nothing around it.
ZSH = r"""
PROMPT= RPROMPT=
fpath=("$FOLDER" $fpath)
autoload -Uz compinit
compinit -u -d "$DUMP"
[[ -z $SOURCED ]] || source $SOURCED
zmodload zsh/zutil
bindkey '^I' complete-word
zstyle ':completion:*' list-grouped false
zstyle ':completion:*' insert-tab false
mark() { print -r -- "@@mark@@" }
compprefuncs=(mark) comppostfuncs=(mark exit)
compadd() {
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
    builtin compadd "$@"
    return
  fi
  local -a hits
  builtin compadd -A hits "$@"
  local hit
  for hit in $hits; do print -r -- "$hit"; done
  builtin compadd "$@"
}
print -r -- "@@ready@@"
"""


def bash(script, words, folder):
    """Candidates for the last of the words, as bash splits the line."""
    run = subprocess.run(["bash", "--norc", "-c", BASH, "bash", script, *words], cwd=folder,
                         capture_output=True, text=True, timeout=60)
    if run.stderr:
        raise AssertionError(run.stderr)
    return sorted(run.stdout.splitlines())


def _read(descriptor, mark, seconds=60):
    """All output until the mark has been seen, or the shell has gone."""
    text, end = "", time.monotonic() + seconds
    while mark(text):
        if not select.select([descriptor], [], [], end - time.monotonic())[0]:
            raise AssertionError(f"zsh is silent after {text!r}")
        try:
            text += os.read(descriptor, 4096).decode()
        except OSError:
            break
    return text.replace("\r", "")


def zsh(functions, line, folder, sourced=""):
    """Candidates that a press of the tabulator finds at the end of the line, with the completion in a
    folder of functions or sourced. What zsh found in the folders of functions is kept in the folder: to look through all
    of them takes each shell ten times as long as the rest."""
    process, terminal = pty.fork()
    if process == 0:
        os.chdir(folder)
        os.environ.update(FOLDER=str(functions), DUMP=str(folder / f".dump-of-{functions.name}"), SOURCED=str(sourced),
                          TERM="dumb", LC_ALL="C.UTF-8")
        os.execvp("zsh", ["zsh", "-f", "-i"])
    try:
        setup = folder / ".setup.zsh"
        setup.write_text(ZSH)
        os.write(terminal, b"stty -echo; source ./.setup.zsh\n")
        _read(terminal, lambda text: "@@ready@@\r" not in text)
        os.write(terminal, line.encode() + b"\t")
        text = _read(terminal, lambda text: text.count("@@mark@@") < 2)
    finally:
        os.close(terminal)
        os.waitpid(process, 0)
    return sorted({word.replace("\\", "") for word in text.split("@@mark@@")[1].split("\n")[1:-1]})
