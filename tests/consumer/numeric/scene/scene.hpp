// Not vcrit's: must never be found in its place.
#error "a header of vcrit includes one of its user's"
