# vcrit completion for bash, printed by `vcrit --completion bash`. The program itself says what may
# follow: words, or a pattern of files behind a colon.
_vcrit() {
  local word=${COMP_WORDS[COMP_CWORD]} line
  [[ $word != '=' ]] || word=
  COMPREPLY=()
  while IFS=$'\t' read -r line _; do
    [[ $line == :* ]] || { COMPREPLY+=("$line"); continue; }
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$word"
      compgen -f -X "!${line:1}" -- "$word" | while IFS= read -r line; do [[ -d $line ]] || printf '%s\n' "$line"; done)
  done < <("${COMP_WORDS[0]}" --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  # The value of a name follows at once.
  [[ ${COMPREPLY[0]-} != *= ]] || compopt -o nospace 2>/dev/null
}

complete -F _vcrit vcrit
