# Comments of this project as Doxygen wants them: the first block is about the file and keeps its layout, then /// before a
# declaration, ///< after one. Characters with a meaning for Doxygen are escaped.
1,/^#pragma once/ {
  s/^\/\/ ?//
  1s/^/\/** \\file\n\\verbatim\n/
  s/^#pragma once/\\endverbatim\n*\/\n&/
  b
}
/^ *\/\// {
  s/([\\@&$#<>%"])/\\\1/g
  s/^( {16,})\/\/ ?/\1\/\/\/< /
  s/^( *)\/\/ ?([^\/<]|$)/\1\/\/\/ \2/
}
/^ *[^ \/].*[^:"]\/\/ / {
  h
  s/^(.*[^:"])\/\/ .*$/\1/
  x
  s/^.*[^:"]\/\/ (.*)$/\1/
  s/([\\@&$#<>%"])/\\\1/g
  s/^/\/\/\/< /
  H
  x
  s/\n/ /
}
# Doxygen 1.9.4 does not find the scope of this specialisation.
s/^(.*struct )std::hash</\1hash</
