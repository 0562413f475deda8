// Which triangles can be left out of a picture: those that cover no sample of it as front faces. Right for every
// rasteriser that rounds window positions by less than cull_step: what is in doubt is kept.
const int kViews = 3;  // the camera, the near and the far region of the shadow map
const uint kTrianglesPerBlock = 256u, kWordsPerBlock = 8u;

struct DrawCommand { uint count, instance_count, first_index, base_vertex, base_instance; };

// Room of the arrays below, in blocks; triangles of view v begin at v * room.
layout(location = 0) uniform uint block_room;
layout(location = 1) uniform uint source_command;  // place of the list's own command among the mesh's commands
