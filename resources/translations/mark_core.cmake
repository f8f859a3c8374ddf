# cmake -DFROM=core -DTO=folder -P mark_core.cmake
# Copies the library's sources with CULLSCOPE_TR(…) written as QT_TRANSLATE_NOOP("core", …), so that lupdate puts every
# sentence into the one context that ui/text/translated.h looks in. (lupdate's own -tr-function-alias would
# scatter them over the classes and namespaces they happen to stand in.)
file(REMOVE_RECURSE ${TO})
file(GLOB_RECURSE sources RELATIVE ${FROM} ${FROM}/*.h ${FROM}/*.cpp)
list(REMOVE_ITEM sources base/message.h)
foreach(source ${sources})
  file(READ ${FROM}/${source} text)
  if(text MATCHES "CULLSCOPE_TR\\(")
    string(REGEX REPLACE "CULLSCOPE_TR\\(" "QT_TRANSLATE_NOOP(\"core\", " text "${text}")
    file(WRITE ${TO}/${source} "${text}")
  endif()
endforeach()
