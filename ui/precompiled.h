// Headers that nearly every file of the desktop includes, parsed once.
#pragma once

#include <QtWidgets>

#include "core/precompiled.h"
