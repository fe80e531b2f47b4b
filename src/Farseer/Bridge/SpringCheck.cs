using System;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Bridge;

internal static class SpringCheck
{
    /// <summary>Throws if both ends are the same body.</summary>
    public static void Distinct(Body body, Body? other, string name)
    {
        if (ReferenceEquals(body, other))
        {
            throw new ArgumentException("A spring needs two different bodies.", name);
        }
    }
}
