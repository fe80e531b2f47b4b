namespace FarseerGames.FarseerPhysics.Collisions;

/// <summary>
/// Says what the surfaces of a pair are together: see <see cref="PhysicsSimulator.MixMaterials"/>. (An addition to the original.)
/// </summary>
/// <param name="geometry1">The geom created first.</param>
/// <param name="geometry2">The other geom.</param>
/// <param name="material">What the coefficients and the rules say; change what is to be otherwise.</param>
public delegate void MaterialMixer(Geom geometry1, Geom geometry2, ref SurfaceMaterial material);
