// The words of the exhibit of programs, in English. A part of en.ts.
export const programs = {
  lab_programs: 'Programs of 1991',
  lab_programs_look:
    'Programs as a class of 1991 wrote them, in C and IRIS GL, run here on the machine itself. Use one, record some frames, and look into every polygon and pixel.',
  lab_keys_programs:
    'Keys: a program has its own, Tab leaves it. Of a recording: ← → step, Home End, space: play.',
  program_saw: 'What a class of 1991 saw',
  program_try: 'Try',
  program_keys: 'What to press',
  program_hidden: 'Hidden surfaces',
  program_hidden_about:
    'Two blocks that pierce each other, and a ring around them. A workstation with a Z-buffer was new, and the class asked what it is worth. So the program can do without. The planes hold indices, not colours: the colour map gives each index its colour.',
  program_hidden_press:
    '1 to 4: who removes what is hidden. Space: turn by itself. Left button: turn by hand. Escape: the end.',
  program_zbuffer: '1 Z-buffer',
  program_zbuffer_see:
    'The machine compares depths at every pixel. Where the blocks pierce, it is right.',
  program_painter: '2 Painter',
  program_painter_see:
    'The program draws the farthest polygon first. Where the blocks pierce, no order is right.',
  program_backface: '3 Back faces',
  program_backface_see:
    'The machine drops polygons that look away. One block alone is right, several are not.',
  program_nobody: '4 As they come',
  program_nobody_see: 'Nobody removes anything: what is drawn last is seen.',
  program_spin: 'Turn by itself',
  program_spin_see: 'On and off. At rest, two recordings can be compared.',
  program_flight: 'Flight over hills',
  program_flight_about:
    'No Z-buffer here. The hills are drawn row by row, the farthest first, and each patch covers what lies behind it. Depth cueing makes far lines dark: the machine takes the index of a pixel from its depth. The instruments stand in overlay planes, above the hills, with a map of their own.',
  program_flight_press:
    'The mouse, or the arrow keys: left and right turn, up and down climb and sink. Escape: the end.',
  program_cueing: 'Depth cueing',
  program_cueing_see: 'On and off. Without it, near and far lines are equally bright.',
  program_hiding: 'Hidden lines',
  program_hiding_see:
    'On and off. Without the patches, the hills behind are seen through those in front.',
  program_slow: 'Slow',
  program_slow_see: 'A third of the speed at the beginning.',
  program_fast: 'Fast',
  program_fast_see: 'Twice the speed at the beginning.',
  program_menu: 'Open the menu',
  program_menu_how:
    'Hold the right button: a menu opens; let go on a line. By keys: Shift+F10, arrows, Enter. For a finger:',
  program_outline:
    'The outline marks the window that gets the keys: click it, or reach it by Tab. In a recorded frame, it marks the pixels that the step changed.',
  program_record: 'Record',
  program_frames: 'Frames',
  program_recording: 'The next frames are recorded ...',
  program_refused: 'This program cannot be recorded: variables in its address record it already.',
  program_missing:
    "This program's page is not here: {0} is expected beside the lab. The site has it, and scripts/lab builds it.",
  program_recorded: 'The recording',
  program_recorded_look:
    'A frame in the order in which the program drew it. Letters are polygons too, one for each run of pixels. Step through it, and click a pixel for its history.',
  program_planes: 'Planes',
  program_window: 'window {0}',
  program_overlay: 'overlay',
  program_underlay: 'underlay',
  program_popup: 'pop-up',
  program_frame: 'Frame',
  program_step: 'Step',
  program_step_of: 'Step {0} of {1}:',
  program_polygons: 'polygons: {0}',
  program_lines: 'lines: {0}',
  program_points: 'points: {0}',
  program_and: ', ',
  program_stop: '.',
  program_clear: 'a plane is cleared.',
  program_pixels: 'letters, or other rectangles of pixels.',
  program_shown: 'the back plane is shown.',
  program_other: 'pixels are copied.',
  program_written: 'Fragments written: {0}.',
  program_lost: 'Killed by the depth test: {0}.',
  program_culled: 'Triangles that look away, dropped: {0}.',
  program_whole: 'The whole frame has {0}.',
  program_time: 'Estimated time: {0}, on {1}.',
  program_depth_legend:
    'Red is nearest, then yellow, green and cyan, blue farthest; nothing is black.',
  program_no_depth: 'This frame does not use the Z-buffer.',
  program_ask_pixel: 'Click a pixel in a picture for its history.',
  program_index: 'Index {0}, through map entry {0}: red, green, blue {1}.',
  program_color: 'Red, green, blue {0}.',
  program_what: 'what',
  program_entry: 'index',
  program_stored: 'stored Z',
  program_event_draw: 'polygon or line',
  program_event_clear: 'clear',
  program_event_pixels: 'letter or pixels',
  program_event_copied: 'copy',
  program_event_shown: 'shown',
} as const;
