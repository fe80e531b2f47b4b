using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Tables;

namespace FarseerGames.FarseerPhysics.Serialization.Scenes;

/// <summary>Makes geoms. All shapes go through the doors of the factories, which refuse what no geom can be.</summary>
internal sealed class GeomReader
{
    private readonly SceneContents _contents;
    private readonly SceneFileOptions _options;

    // Of a wall of equal bricks each copies the one before.
    private Geom? _last;
    private string _lastShape = "";
    private Vector2 _lastSize;

    public GeomReader(SceneContents contents, SceneFileOptions options)
    {
        _contents = contents;
        _options = options;
    }

    public Geom Read(SceneObject members)
    {
        SceneNode node = members.Take("body");
        Body body = SceneReader.ItemAt(node, _contents.BodyItems, node.Whole());
        Geom model = Model(members);
        Vector2 offset = members.TryTake("offset", out SceneNode place) ? place.Vector() : Vector2.Zero;
        float turn = members.TryTake("rotationOffset", out SceneNode rotation) ? rotation.Single() : 0;
        Geom? made = null;
        SceneObject.Try(members.Node, body, model, (b, m) => made = new Geom(b, m, offset, turn));
        Geom geom = made!;
        if (members.TryTake("collisionGridCellSize", out SceneNode cell)
            && cell.Single() is float size
            && size != geom.CollisionGridCellSize)
        {
            SceneObject.Try(cell, geom, size, static (g, v) => g.CollisionGridCellSize = v);
        }

        GeomTable.All.Read(geom, members);
        if (members.TryTake("segmentMaterials", out SceneNode segments))
        {
            ReadSegments(geom, segments);
        }

        if (members.TryTake("tag", out SceneNode tag))
        {
            geom.Tag = _options.Tag(tag.Text());
        }

        return geom;
    }

    private Geom Model(SceneObject members)
    {
        SceneNode name = members.Take("shape");
        string shape = name.Text();
        Geom? made = null;
        switch (shape)
        {
            case nameof(FormKind.Box):
                Vector2 size = members.Take("size").Vector();
                if (_last is not null && _lastShape == shape && _lastSize == size)
                {
                    return _last;
                }

                Make(size, v => GeomFactory.Instance.CreateRectangleGeom(new Body(), v.X, v.Y));
                _lastSize = size;
                break;
            case nameof(FormKind.Circle):
                int edges = members.TryTake("numberOfEdges", out SceneNode count) ? count.Whole() : 32;
                Make(members.Take("radius").Single(), v => GeomFactory.Instance.CreateCircleGeom(new Body(), v, edges));
                break;
            case nameof(FormKind.Rounded):
                float radius = members.Take("radius").Single();
                Make(members.Take("size").Vector(), v => GeomFactory.Instance.CreateRoundedRectangleGeom(new Body(), v.X, v.Y, radius));
                break;
            case nameof(FormKind.Capsule):
                float around = members.Take("radius").Single();
                Make(Ends(members), v => GeomFactory.Instance.CreateCapsuleGeom(new Body(), v[0], v[1], around));
                break;
            case nameof(FormKind.Segment):
                Make(Ends(members), v => GeomFactory.Instance.CreateSegmentGeom(new Body(), v[0], v[1]));
                break;
            case nameof(FormKind.Chain):
                bool isLoop = members.TryTake("isLoop", out SceneNode loop) && loop.Flag();
                Make(members.Take("points").Vectors(), v => GeomFactory.Instance.CreateChainGeom(new Body(), new Vertices(v), isLoop));
                break;
            case nameof(FormKind.Outline):
                Make(members.Take("points").Vectors(), v => new Geom(new Body(), new Vertices(v), 0));
                break;
            default:
                throw name.Error("is no shape of a geom");
        }

        _last = made;
        _lastShape = shape;
        return made!;

        void Make<T>(T of, Func<T, Geom> make) => SceneObject.Try(members.Node, make, of, (act, value) => made = act(value));
    }

    private static Vector2[] Ends(SceneObject members)
    {
        SceneNode node = members.Take("points");
        Vector2[] points = node.Vectors();
        return points.Length == 2 ? points : throw node.Error("must be two points");
    }

    private static void ReadSegments(Geom geom, SceneNode segments)
    {
        List<SceneNode> items = segments.Items();
        if (items.Count != geom.SegmentCount)
        {
            throw segments.Error("must have an item for each segment");
        }

        foreach ((SceneNode item, int i) in items.Select(static (item, i) => (item, i)).Where(static pair => !pair.item.IsNull))
        {
            var members = new SceneObject(item);
            var material = default(SurfaceMaterial);
            SceneObject.Try(item, geom, members, (g, m) =>
            {
                material.Friction = m.Take("friction").Single();
                material.Restitution = m.Take("restitution").Single();
                material.Speed = m.Take("speed").Single();
                material.RollingResistance = m.Take("rollingResistance").Single();
                g.SetSegmentMaterial(i, material);
            });
            members.Finish();
        }
    }
}
