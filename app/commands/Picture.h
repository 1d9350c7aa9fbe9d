// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <string>

#include "editor/render/Layers.h"
#include "simcore/base/Error.h"
#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace CLI {
class App;
}

namespace glenoid {

/// What the user wants to see in a picture.
struct PictureWishes {
  std::string out;             ///< PNG to write
  int width = 1280, height = 960;
  std::string camera;          ///< id of the scenario's camera, a side ("anterior"), "scope" or "scope:TOOL"; empty: the scenario's first
  double haze = 0, bleeding = 0;  ///< 0…1, through an arthroscope
  std::string layers;          ///< as layersFromWords reads them; empty: the default
  std::string part;            ///< id or number of the only part shown, framed; empty: all
  std::string sheet;           ///< as sheetNamed reads it; empty: one picture
  std::string colour;          ///< as quantityNamed reads it; empty: parts as they look
  std::string colourRange;     ///< as checkColours reads it; empty: from the values
  bool stretchLaw = true;      ///< whether the steps had it
  std::optional<FieldLook> field;  ///< values of its own, in place of `colour`
};

/// --colour and --colour-range. The wishes must live as long as the command.
void addColourOptions(CLI::App& command, PictureWishes& wishes);

/// Tells what is wrong with colour and colourRange before anything is run. Fails with BadUsage.
Result<Done> checkColours(const PictureWishes& wishes);

/// "1280x960" → sizes. Fails with BadUsage or OutOfRange (1…16384).
Result<Done> readSize(const std::string& words, PictureWishes& wishes);

/// Draws without any display and writes the file. Fails with UnknownId (camera, part), BadUsage (layers),
/// NoGraphics, FileUnwritable.
Result<Done> drawPicture(const Model& model, const State& state, std::span<const ContactView> contacts,
                         const PictureWishes& wishes, std::span<const DentView> dents = {});

}  // namespace glenoid
