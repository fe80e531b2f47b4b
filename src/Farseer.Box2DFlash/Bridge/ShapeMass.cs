namespace Box2D.Bridge;

/// <summary>Mass of a shape in double precision: centre in the body, inertia about that centre.</summary>
internal readonly record struct ShapeMass(double Mass, double X, double Y, double Inertia);
