using System;
using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Scenes;

/// <summary>Makes paths of bodies, geoms, joints and springs that are there.</summary>
internal sealed class PathReader
{
    private readonly SceneContents _contents;

    public PathReader(SceneContents contents) => _contents = contents;

    public Path Read(SceneObject members)
    {
        float width = members.Take("width").Single();
        float height = members.Take("height").Single();
        float mass = members.Take("mass").Single();
        bool isEndless = members.Take("isEndless").Flag();
        Path? made = null;
        SceneObject.Try(members.Node, this, mass, (_, m) => made = new Path(width, height, m, isEndless));
        Path path = made!;
        SceneNode points = members.Take("controlPoints");
        foreach (System.Numerics.Vector2 point in points.Vectors())
        {
            SceneObject.Try(points, path, point, static (p, v) => p.Add(v));
        }

        path.Placed = members.TryTake("placed", out SceneNode placed) ? new Vertices(placed.Vectors()) : new Vertices();
        Each(members, "bodies", _contents.BodyItems, path.Add);
        Each(members, "geoms", _contents.GeomItems, path.Add);
        Each(members, "joints", _contents.JointItems, path.Add);
        Each(members, "springs", _contents.SpringItems, path.Add);
        Each(members, "madeBodies", _contents.BodyItems, item => path.Made.Add(item));
        Each(members, "madeGeoms", _contents.GeomItems, item => path.Made.Add(item));
        Each(members, "madeJoints", _contents.JointItems, item => path.Made.Add(item));
        Each(members, "madeSprings", _contents.SpringItems, item => path.Made.Add(item));
        return path;
    }

    private static void Each<T>(SceneObject members, string name, List<T> items, Action<T> act)
        where T : class
    {
        if (members.TryTake(name, out SceneNode node))
        {
            foreach (int place in node.Wholes())
            {
                T item = SceneReader.ItemAt(node, items, place);
                SceneObject.Try(node, act, item, static (a, v) => a(v));
            }
        }
    }
}
