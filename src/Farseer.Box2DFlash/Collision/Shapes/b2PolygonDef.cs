using Box2D.Bridge;
using Box2D.Common;
using Box2D.Common.Math;
using Farseer.Engine.Numerics;

namespace Box2D.Collision.Shapes;

/// <summary>The definition of a convex polygon.</summary>
/// <example>
/// <code>
/// var crate = new b2PolygonDef { density = 1, friction = 0.4f };
/// crate.SetAsBox(0.5f, 0.5f);
/// body.CreateShape(crate);
/// body.SetMassFromShapes();
/// </code>
/// </example>
public class b2PolygonDef : b2ShapeDef
{
    /// <summary>Makes a definition without vertices.</summary>
    public b2PolygonDef()
        : base(b2Shape.e_polygonShape)
    {
        vertices = new b2Vec2[b2Settings.b2_maxPolygonVertices];
        for (int i = 0; i < vertices.Length; i++)
        {
            vertices[i] = new b2Vec2();
        }
    }

    /// <summary>
    /// The corners in the body, metres, of which the first <see cref="vertexCount"/> count: counter-clockwise (from the x axis
    /// towards the y axis), convex, no two at one position. The array has room for 8; set a longer one for more corners.
    /// </summary>
    public b2Vec2[] vertices { get; set; }

    /// <summary>How many of the vertices count, at least 3. Default 0, which must be set.</summary>
    public int vertexCount { get; set; }

    /// <summary>Makes a box about the origin of the body.</summary>
    /// <param name="hx">Half its width, metres; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="hy">Half its height, metres; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">A value is out of its range.</exception>
    public void SetAsBox(float hx, float hy)
    {
        Require.Length(hx, nameof(hx));
        Require.Length(hy, nameof(hy));
        if (vertices is null || vertices.Length < 4)
        {
            vertices = new[] { new b2Vec2(), new b2Vec2(), new b2Vec2(), new b2Vec2() };
        }

        vertexCount = 4;
        Corner(0, -hx, -hy);
        Corner(1, hx, -hy);
        Corner(2, hx, hy);
        Corner(3, -hx, hy);
    }

    /// <summary>Makes a box anywhere in the body.</summary>
    /// <param name="hx">Half its width, metres; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="hy">Half its height, metres; above 0, from 1.1·10⁻¹⁹ to 9.2·10¹⁸.</param>
    /// <param name="center">Its centre; null leaves it about the origin and unturned, as in the original.</param>
    /// <param name="angle">By how much it is turned, radians.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">A value is not finite, or a half side out of its range.</exception>
    public void SetAsOrientedBox(float hx, float hy, b2Vec2? center = null, float angle = 0)
    {
        Require.Finite(angle, nameof(angle));
        if (center is not null)
        {
            Require.Vector(center, nameof(center));
        }

        SetAsBox(hx, hy);
        if (center is null)
        {
            return;
        }

        StableMath.SinCos(angle, out double sin, out double cos);
        for (int i = 0; i < vertexCount; i++)
        {
            double x = vertices[i].x;
            double y = vertices[i].y;
            vertices[i].Set((float)(center.x + ((cos * x) - (sin * y))), (float)(center.y + ((sin * x) + (cos * y))));
        }
    }

    private void Corner(int index, float x, float y)
    {
        vertices[index] ??= new b2Vec2();
        vertices[index].Set(x, y);
    }
}
