# Writes the header FROM to TO with the project's own includes as a user's compiler finds them.
file(READ ${FROM} text)
string(REGEX REPLACE "#include \"([^\"]+)\"" "#include \"vcrit/\\1\"" text "${text}")
file(WRITE ${TO} "${text}")
