// Writes the parameters as rows of the object catalogue, for the EDS files of the drive objects.
#include <cstdio>
#include <fstream>

#include "drive/reference/catalogue_rows.hpp"

int main(int count, char** words) {
  if (count != 2) return std::fputs("usage: write_catalogue_rows FILE\n", stderr), 2;
  std::ofstream file{words[1], std::ios::binary};
  file << drive::catalogue_rows() << std::flush;
  if (file) return 0;
  std::fprintf(stderr, "%s: cannot be written\n", words[1]);
  return 1;
}
