namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// Says what the surfaces of a pair are together: see <see cref="PhysicsSimulator.MixMaterials"/>. (An addition to the original.)
/// </summary>
/// <param name="geometry1">The geom created first.</param>
/// <param name="geometry2">The other geom.</param>
/// <param name="material">What the coefficients and the rules say; change what is to be otherwise.</param>
/// <example>
/// <code>
/// simulator.MixMaterials = (Geom one, Geom two, ref SurfaceMaterial mixed) =&gt;
/// {
///     if (one.Tag is "ice" || two.Tag is "ice")
///     {
///         mixed.Friction = 0.02f;
///     }
/// };
/// </code>
/// </example>
public delegate void MaterialMixer(Geom geometry1, Geom geometry2, ref SurfaceMaterial material);
