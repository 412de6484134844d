# What doxygen reads of a header: the opening comment belongs to the file, <F_n> in a comment is a mean
# and not HTML, and "Eq. 24" does not end a sentence.
1,/^#pragma once/s|^//|///|
1s|^|/// \\file\n|
:mean
s|\(//.*\)<|\1\&lt;|
t mean
s|\(//.*\)Eq\. |\1Eq.\\ |
