// Writes one frame of a scene as a portable grey or colour map, to look at: scene_frame SCENE FRAME OUT.pgm
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/simulation/simulated_scan.h"

int main(int argc, char** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: scene_frame SCENE FRAME OUT.pgm\n";
    return 2;
  }
  try
  {
    const weld_profiler::SimulatedScan scan(weld_profiler::loadScene(argv[1]));
    std::vector<std::uint8_t> pixels;
    scan.render(std::atoi(argv[2]), pixels);
    const bool colour = scan.encoding() == "bgr8";
    for (std::size_t i = 0; colour && i < pixels.size(); i += 3)
      std::swap(pixels[i], pixels[i + 2]);
    const bool wide = scan.encoding() == "mono16";
    for (std::size_t i = 0; wide && i < pixels.size(); i += 2)
      std::swap(pixels[i], pixels[i + 1]);  // the format is big endian
    std::ofstream out(argv[3], std::ios::binary);
    out << (colour ? "P6 " : "P5 ") << scan.width() << " " << scan.height() << (wide ? " 65535\n" : " 255\n");
    out.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
    out.close();
    if (!out)
      throw weld_profiler::InputError(std::string(argv[3]) + ": cannot be written");
  }
  catch (const weld_profiler::Error& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
