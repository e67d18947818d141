// The stories as they are told: titles, and the sentences of the stages by the step where a stage
// stands: 'begin', 'end', or the first of this test ("split"), or of its answer ("split.none"),
// after the stage before. What follows a bar speaks of the page: slides leave it out.
export const stories = {
  first: {
    title: 'What is a hidden surface?',
    begin:
      'A surface behind another one is hidden: a picture must not show it. Here are three polygons, of which each covers the next, so none can simply be painted first. |Press Next: a famous algorithm of 1972 solves it before your eyes, step by step.',
    'farthest-corner.sorted':
      'First it sorts the polygons by their farthest corners. |The left view is the picture so far, the right one shows the scene from elsewhere. On the right margin the line of the algorithm is lit.',
    'z-extents.no':
      'May the farthest be painted first? It asks about two polygons: the yellow outline and the broken blue one. Their depths overlap, so five tests follow.',
    "4'-before.no":
      'All tests say no, also the other way round: neither may be painted before the other. One must be cut.',
    split: 'It cuts one in two, by the plane of the other. The two new pieces have a pink outline.',
    end: 'Done: every pixel is right. |Drag the picture to move the eye, explore freely with another algorithm, or take the next story.',
  },
  painter: {
    title: 'The painter fails',
    begin:
      'A painter begins with what is far and paints nearer things over it. The algorithm of this name sorts polygons by one distance each. Is one number enough?',
    'distance.sorted':
      'The order is decided, by the farthest corners alone. Nobody asks whether it is right.',
    end: 'Some pixels are wrong. |The red card names the steps that spoiled them. Turn the eye: from some places the same order is right.',
  },
  pinwheel: {
    title: 'A pinwheel, one cut',
    begin: 'Four bars lie over one another in a ring. How often must they be cut?',
    'marks.cycle':
      'The bars were moved one after the other, until a marked one would have to move again.',
    split: 'One cut opens the ring. |Positive numbers are distances behind the plane.',
    end: 'Five pieces, four bars, one cut.',
  },
  'z-buffer': {
    title: 'The Z-buffer asks every pixel',
    begin:
      'The Z-buffer sorts nothing. It keeps a depth Z for every pixel, and a polygon is written where its own z is smaller.',
    'z-buffer': 'The first polygon is nearer than the empty background everywhere.',
    'z-buffer.some': 'This one is nearer only at some of its pixels; the others stay as they are.',
    end: 'The order of the polygons did not matter. The price was memory: a number at every pixel.',
  },
  'scan-line': {
    title: 'Line by line',
    begin:
      'Scan-line algorithms need only one row of the picture in memory. They know where each polygon enters and leaves the row.',
    'edge-table': 'All polygons wait in a table, by the line in which they begin.',
    'active-edges':
      'A line crosses some of them. Between two neighbouring ends lies a sample span.',
    'span.one-nearest':
      'In this span two polygons lie over each other; the nearer at both ends is seen in all of it.',
    end: 'The picture is whole, and no depth was stored.',
  },
};

export type Stories = typeof stories;
