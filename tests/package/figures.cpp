// A user of requad::figures: the catalogue of figures.
#include <requad/figures/pictures/catalogue.hpp>

int main() { return requad::figures::catalogue().empty() ? 1 : 0; }
