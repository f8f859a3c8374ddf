#!/bin/sh
# update.sh LUPDATE SOURCE_DIR BUILD_DIR TS...: brings the catalogues up to date with the sources of ui, app and core.
set -eu
lupdate=$1 source=$2 build=$3
shift 3
cmake -DFROM="$source/core" -DTO="$build/core" -P "$source/resources/translations/mark_core.cmake"
mkdir -p "$build/core"
exec "$lupdate" -silent -no-obsolete -locations none -source-language en -I "$source" "$source/ui" "$source/app" "$build/core" -ts "$@"
